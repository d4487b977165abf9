//! Base64, for pictures inside of text.
//!
//! Source: Josefsson, "The Base16, Base32, and Base64 Data Encodings", RFC 4648, 2006, section 4.

const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// The bytes as base64, padded, on one line.
///
/// ```
/// assert_eq!(farop::grade::write::base64(b"farop"), "ZmFyb3A=");
/// ```
#[must_use]
pub fn base64(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for group in bytes.chunks(3) {
        let byte = |at: usize| u32::from(group.get(at).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for letter in 0..4 {
            // A group of n bytes has n + 1 letters; the rest is padding.
            let shown = LETTERS[(bits >> (18 - 6 * letter) & 63) as usize];
            text.push(if letter <= group.len() { char::from(shown) } else { '=' });
        }
    }
    text
}

/// A PNG as an address that needs no network.
#[must_use]
pub fn png_url(bytes: &[u8]) -> String {
    format!("data:image/png;base64,{}", base64(bytes))
}

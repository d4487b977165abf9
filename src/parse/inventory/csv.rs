//! CSV: a table as rows of fields, each with its place.
//!
//! bytes -CSV-> fields and where they stand
//!
//! Fields are separated by what the first line has most of: `,`, `;` or tabs. `"..."` holds separators, line ends and `""` for a quote. Lines that are empty or
//! begin with `#` say nothing.
//!
//! Why our own: it is shorter than the glue of a library, and each field keeps its bytes for a message with line and column.
//!
//! Space: bytes of the source. Cost: one pass. Source: RFC 4180.

use crate::diagnostic::{Diagnostic, Span};

/// A field, without quotes and blanks around it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Field {
    pub text: String,
    pub span: Span,
}

/// Rows of a table.
pub(super) struct Table {
    pub rows: Vec<Vec<Field>>,
    /// Numbers are written `12,5`: the separator is not a comma.
    pub has_decimal_commas: bool,
}

/// Splits a text into rows.
///
/// # Errors
/// A quote that is not closed, or with something behind it.
pub(super) fn table(text: &[u8]) -> Result<Table, Diagnostic> {
    let separator = separator(text);
    let mut reader = Reader { text, at: 0, separator };
    if text.starts_with(b"\xEF\xBB\xBF") {
        reader.at = 3;
    }
    let mut rows = Vec::new();
    while reader.at < text.len() {
        let row = reader.row()?;
        if row.iter().any(|field| !field.text.is_empty()) {
            rows.push(row);
        }
    }
    Ok(Table { rows, has_decimal_commas: separator != b',' })
}

/// What the first line that says something has most of.
fn separator(text: &[u8]) -> u8 {
    let mut lines = text.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii);
    let first = lines.find(|line| !line.is_empty() && !line.starts_with(b"#")).unwrap_or_default();
    let count = |separator: u8| first.iter().filter(|&&byte| byte == separator).count();
    // Of equals the last one is taken: a comma where there is none at all.
    [b'\t', b';', b','].into_iter().max_by_key(|&separator| count(separator)).unwrap_or(b',')
}

struct Reader<'a> {
    text: &'a [u8],
    at: usize,
    separator: u8,
}

impl Reader<'_> {
    fn byte(&self) -> Option<u8> {
        self.text.get(self.at).copied()
    }

    /// A row, and the end of its line.
    fn row(&mut self) -> Result<Vec<Field>, Diagnostic> {
        let mut fields = Vec::new();
        if self.byte() == Some(b'#') {
            self.skip_line();
            return Ok(fields);
        }
        loop {
            fields.push(self.field()?);
            match self.byte() {
                Some(byte) if byte == self.separator => self.at += 1,
                _ => break,
            }
        }
        self.skip_line();
        Ok(fields)
    }

    fn skip_line(&mut self) {
        let rest = &self.text[self.at..];
        self.at += rest.iter().position(|&byte| byte == b'\n').map_or(rest.len(), |end| end + 1);
    }

    fn field(&mut self) -> Result<Field, Diagnostic> {
        while matches!(self.byte(), Some(b' ' | b'\t')) && self.byte() != Some(self.separator) {
            self.at += 1;
        }
        if self.byte() == Some(b'"') {
            return self.quoted();
        }
        let start = self.at;
        while self.byte().is_some_and(|byte| byte != self.separator && byte != b'\n') {
            self.at += 1;
        }
        let bytes = self.text[start..self.at].trim_ascii_end();
        Ok(Field { text: String::from_utf8_lossy(bytes).into_owned(), span: Span::new(start, start + bytes.len()) })
    }

    fn quoted(&mut self) -> Result<Field, Diagnostic> {
        let start = self.at;
        let mut bytes = Vec::new();
        self.at += 1;
        loop {
            match self.byte() {
                None => {
                    let error =
                        Diagnostic::error("a quote is never closed").at(Span::new(start, start + 1), "it begins here");
                    return Err(error.help("write `\"` behind the field; a quote in it is written twice"));
                }
                Some(b'"') if self.text.get(self.at + 1) == Some(&b'"') => {
                    bytes.push(b'"');
                    self.at += 2;
                }
                Some(b'"') => break,
                Some(byte) => {
                    bytes.push(byte);
                    self.at += 1;
                }
            }
        }
        self.at += 1;
        let span = Span::new(start, self.at);
        while matches!(self.byte(), Some(b' ' | b'\t' | b'\r')) && self.byte() != Some(self.separator) {
            self.at += 1;
        }
        if self.byte().is_some_and(|byte| byte != self.separator && byte != b'\n') {
            let error = Diagnostic::error("something stands behind a closing quote");
            return Err(error
                .at(Span::new(self.at, self.at + 1), "a separator was expected")
                .help("a quote within a field is written twice"));
        }
        Ok(Field { text: String::from_utf8_lossy(&bytes).trim().to_string(), span })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(text: &str) -> Vec<Vec<String>> {
        let table = table(text.as_bytes()).expect("a table");
        table.rows.into_iter().map(|row| row.into_iter().map(|field| field.text).collect()).collect()
    }

    #[test]
    fn quotes_blanks_and_line_ends() {
        let found = texts("\u{FEFF}a, b ,c\r\n# a remark\r\n\r\n\"x, \"\"y\"\"\" , 2,\n\"two\nlines\",,3");
        assert_eq!(found, [vec!["a", "b", "c"], vec!["x, \"y\"", "2", ""], vec!["two\nlines", "", "3"]]);
    }

    #[test]
    fn the_separator_is_what_the_first_line_has_most_of() {
        assert_eq!(texts("a;b,c;d\n1;2,5;3"), [["a", "b,c", "d"], ["1", "2,5", "3"]]);
        assert_eq!(texts("a\tb\n1\t\t"), [vec!["a", "b"], vec!["1", "", ""]]);
        assert_eq!(texts("a\n1"), [["a"], ["1"]]);
    }

    #[test]
    fn open_quotes_are_told() {
        assert!(table(b"a,b\n\"1,2").is_err() && table(b"a\n\"1\"2").is_err());
    }
}

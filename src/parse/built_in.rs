//! Built-in scenes by name: `NAME` or `NAME:SIZE`, as the command line and imports write them behind `spd:`.

use crate::spd::{self, Curves};

/// The built-in scene of that name, or a message that lists them.
///
/// # Errors
/// There is none.
pub fn find(name: &str) -> Result<&'static spd::SpdScene, String> {
    spd::find(name).ok_or_else(|| {
        let names: Vec<_> = spd::SCENES.iter().map(|scene| scene.name).collect();
        format!("there is no built-in scene `{name}`; there is {}", names.join(", "))
    })
}

/// The NFF text of `NAME[:SIZE]`.
///
/// # Errors
/// A message: no such scene, no such size.
pub fn text(built_in: &str, curves: Curves) -> Result<Vec<u8>, String> {
    let (name, size) = built_in.split_once(':').map_or((built_in, None), |(name, size)| (name, Some(size)));
    let scene = find(name)?;
    let size = match size {
        None => scene.default_size,
        Some(text) => {
            text.parse().map_err(|_| format!("spd:{built_in}: `{text}` is not a size; write spd:{name}:4"))?
        }
    };
    let mut text = Vec::new();
    spd::generate(scene, size, curves, &mut text).map_err(|error| format!("spd:{built_in}: {error}"))?;
    Ok(text)
}

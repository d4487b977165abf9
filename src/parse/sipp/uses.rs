//! `use`, `copy`, `clone` and `import`: nodes whose content stands elsewhere.

use super::Reader;
use super::block::with_suggestion;
use super::draft::{Copying, Node, NodeKind};
use super::trouble::Trouble;
use super::vocabulary::{FILE_WORDS, ITEM_WORDS, TRANSFORM_WORDS};
use super::words::Kind;
use crate::diagnostic::{Diagnostic, Span};
use crate::math::Affine3;
use crate::parse::wording::{plain, quote};

impl Reader<'_> {
    /// `use NAME`, with transforms in braces or without.
    pub(super) fn reference(&mut self, keyword: Span, line: u32) -> Result<u32, Trouble> {
        let how = match self.words.bytes(keyword) {
            b"use" => Copying::Use,
            b"copy" => Copying::Copy,
            _ => Copying::Clone,
        };
        let target = self.words.name("an object")?;
        let mut node = empty_node(target, keyword, line);
        let shader = self.placing(&mut node, how == Copying::Clone)?;
        node.kind = NodeKind::Reference { how, target, shader };
        Ok(self.add_node(node))
    }

    /// `import "FILE"`, with transforms in braces or without.
    pub(super) fn import(&mut self, keyword: Span, line: u32) -> Result<u32, Trouble> {
        let file = self.words.text("`import \"FILE\"`")?;
        let imported = self.imported(file);
        let mut node = empty_node(file, keyword, line);
        self.placing(&mut node, false)?;
        match imported {
            Ok(index) => node.kind = NodeKind::Import(index),
            // What stands behind it was read all the same.
            Err(trouble) => self.tell(trouble),
        }
        Ok(self.add_node(node))
    }

    /// Transforms in braces, if there are any; returns the shader that replaces others.
    fn placing(&mut self, node: &mut Node, takes_shader: bool) -> Result<Option<Span>, Trouble> {
        let mut shader = None;
        if self.words.take_if(Kind::Open).is_none() {
            return Ok(shader);
        }
        self.open_blocks.push(node.keyword);
        while self.goes_on() && self.words.take_if(Kind::Close).is_none() {
            match self.placing_item(node, takes_shader) {
                Ok(Placing::Transform) => {}
                Ok(Placing::Shader(name)) => shader = Some(name),
                Ok(Placing::End) => break,
                Err(trouble) => {
                    self.tell(trouble);
                    self.recover(|word| is_transform(word) || takes_shader && word == b"shader");
                }
            }
        }
        self.open_blocks.pop();
        Ok(shader)
    }

    fn placing_item(&mut self, node: &mut Node, takes_shader: bool) -> Result<Placing, Trouble> {
        let owner = plain(self.words.bytes(node.keyword));
        let token = self.words.expect_word(&format!("`{owner}`"), "a transform")?;
        let word = self.words.bytes(token.span);
        if is_transform(word) {
            node.parent_from_local = self.transform(node.parent_from_local)?;
            node.is_transformed = true;
            return Ok(Placing::Transform);
        }
        if word == b"shader" && takes_shader {
            self.words.take();
            return Ok(Placing::Shader(self.words.name("a shader")?));
        }
        if word == b"shader" {
            self.words.take();
            let error = Diagnostic::error(format!("`{owner}` cannot change shaders")).at(token.span, "not here");
            return Err(error.help("only `clone` makes surfaces of its own: write `clone NAME { shader X }`").into());
        }
        if FILE_WORDS.iter().chain(ITEM_WORDS).any(|known| known.as_bytes() == word) {
            self.not_closed(token.span);
            return Ok(Placing::End);
        }
        self.check_text(word, token.span)?;
        self.words.take();
        let error = Diagnostic::error(format!("{} where `{owner}` has transforms", quote(word)));
        Err(with_suggestion(error.at(token.span, "expected a transform"), word, TRANSFORM_WORDS).into())
    }

    pub(super) fn add_node(&mut self, node: Node) -> u32 {
        self.draft.nodes.push(node);
        self.draft.nodes.len() as u32 - 1
    }
}

enum Placing {
    Transform,
    Shader(Span),
    /// The block was probably meant to end here.
    End,
}

/// A node without content.
pub(super) fn empty_node(name: Span, keyword: Span, line: u32) -> Node {
    Node {
        name,
        keyword,
        line,
        parent_from_local: Affine3::IDENTITY,
        is_transformed: false,
        kind: NodeKind::Nested,
        surfaces: Vec::new(),
        children: Vec::new(),
    }
}

pub(super) fn is_transform(word: &[u8]) -> bool {
    TRANSFORM_WORDS.iter().any(|known| known.as_bytes() == word)
}

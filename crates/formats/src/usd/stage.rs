//! The prims of a file: what of them is taken is noted by its place and read when it is needed.

use std::collections::BTreeMap;

use vides_document::error::TooMany;
use vides_engine::limits::{MAX_LEVELS, MAX_NODES};

use super::lexer::{Lexer, Token, unescaped};
use crate::error::{Cause, Error, Result, Wanted};

/// An attribute that has a value.
#[derive(Debug)]
pub(super) struct Attribute<'a> {
    pub(super) name: &'a str,
    /// Where the value, or the braces of the samples, stand.
    pub(super) at: usize,
    pub(super) samples: bool,
    /// Of a primvar: what its values belong to.
    pub(super) interpolation: &'a str,
}

/// A prim that defines something.
#[derive(Debug, Default)]
pub(super) struct Prim<'a> {
    pub(super) kind: &'a str,
    /// The identifier.
    pub(super) name: &'a str,
    pub(super) display_name: String,
    /// What we wrote it for.
    pub(super) role: String,
    pub(super) parent: Option<usize>,
    pub(super) at: usize,
    /// A class, an `over`, what is switched off, and all in them.
    pub(super) out: bool,
    pub(super) attributes: Vec<Attribute<'a>>,
    pub(super) skinned: bool,
    /// Where a spline moves it.
    pub(super) spline: Option<usize>,
}

/// All of a file.
#[derive(Debug)]
pub(super) struct Stage<'a> {
    pub(super) lexer: Lexer<'a>,
    pub(super) prims: Vec<Prim<'a>>,
    /// What is not taken, and how many of it.
    pub(super) told: BTreeMap<&'a str, usize>,
    pub(super) doc: String,
    pub(super) title: String,
    /// The unit of a file of ours, which may be empty.
    pub(super) unit: Option<String>,
    /// The name of the camera that was shown in a file of ours.
    pub(super) camera: String,
    pub(super) up: String,
    pub(super) metres: Option<f64>,
    pub(super) start: Option<f64>,
    pub(super) end: Option<f64>,
    pub(super) codes_per_second: Option<f64>,
    pub(super) frames_per_second: Option<f64>,
}

/// What gives a prim the contents of others.
const ARCS: &[&str] = &[
    "references",
    "payload",
    "inherits",
    "specializes",
    "variantSets",
    "instanceable",
    "clips",
    "relocates",
    "subLayers",
];

/// Attributes that are taken beside those of places.
const TAKEN: &[&str] = &[
    "visibility",
    "focalLength",
    "verticalAperture",
    "horizontalApertureOffset",
    "verticalApertureOffset",
    "clippingRange",
    "projection",
    "fStop",
    "points",
    "faceVertexCounts",
    "faceVertexIndices",
    "subdivisionScheme",
    "primvars:displayColor",
    "primvars:displayColor:indices",
    "curveVertexCounts",
    "type",
    "wrap",
    "inputs:color",
    "inputs:intensity",
    "inputs:exposure",
    "inputs:normalize",
    "inputs:radius",
    "inputs:angle",
    "treatAsPoint",
    "inputs:shaping:cone:angle",
    "inputs:shaping:cone:softness",
];

impl<'a> Stage<'a> {
    /// # Errors
    /// What is wrong in the file, with the line.
    pub(super) fn parse(text: &'a str) -> Result<Self> {
        let mut stage = Self {
            lexer: Lexer::new(text),
            prims: Vec::new(),
            told: BTreeMap::new(),
            doc: String::new(),
            title: String::new(),
            unit: None,
            camera: String::new(),
            up: String::new(),
            metres: None,
            start: None,
            end: None,
            codes_per_second: None,
            frames_per_second: None,
        };
        if stage.lexer.sign(b'(') {
            stage.layer_metadata()?;
        }
        let mut open = Vec::new();
        while stage.statement(&mut open)? {}
        Ok(stage)
    }

    fn tell(&mut self, what: &'a str) {
        *self.told.entry(what).or_default() += 1;
    }

    /// One statement within the innermost open prim; false at the end.
    fn statement(&mut self, open: &mut Vec<usize>) -> Result<bool> {
        let before = self.lexer;
        match self.lexer.next()? {
            Token::End if open.is_empty() => return Ok(false),
            Token::Sign(b';') => {}
            Token::Sign(b'}') if open.pop().is_some() => {}
            Token::Word(word @ ("def" | "over" | "class")) => self.prim(word, open)?,
            Token::Word("variantSet") if !open.is_empty() => {
                self.lexer.text()?;
                self.lexer.need("=")?;
                self.lexer.skip_value()?;
            }
            Token::Word("reorder") => {
                self.lexer.word()?;
                self.lexer.need("=")?;
                self.lexer.skip_value()?;
            }
            Token::Word(word) => match open.last() {
                Some(&prim) => self.property(word, prim)?,
                None => return Err(before.expected(Wanted::Literal("def"))),
            },
            _ => return Err(before.expected(Wanted::Name)),
        }
        Ok(true)
    }

    fn prim(&mut self, specifier: &'a str, open: &mut Vec<usize>) -> Result<()> {
        let at = self.lexer.at();
        let before = self.lexer;
        if self.prims.len() >= MAX_NODES {
            return Err(Error::Document(TooMany::Nodes.into()));
        }
        if open.len() >= MAX_LEVELS {
            return Err(before.wrong(Cause::Deep));
        }
        let (kind, name) = match self.lexer.next()? {
            Token::Word(kind) => (kind, self.lexer.text()?),
            Token::Text(name) => ("", name),
            _ => return Err(before.expected(Wanted::Name)),
        };
        let parent = open.last().copied();
        // What an instancer repeats does not stand where it is.
        let inherited = parent.is_some_and(|parent| {
            let parent = &self.prims[parent];
            parent.out || parent.kind == "PointInstancer"
        });
        if specifier != "def" && !inherited {
            self.tell(specifier);
        }
        let mut prim = Prim {
            kind,
            name,
            parent,
            at,
            out: inherited || specifier != "def",
            ..Prim::default()
        };
        if self.lexer.sign(b'(') {
            self.prim_metadata(&mut prim)?;
        }
        self.lexer.need("{")?;
        open.try_reserve(1)?;
        open.push(self.prims.len());
        self.prims.try_reserve(1)?;
        self.prims.push(prim);
        Ok(())
    }

    /// Entries `key = value` up to the closing bracket. `take` reads the values that it wants and
    /// says whether it did.
    fn entries(&mut self, take: &mut dyn FnMut(&mut Self, &'a str) -> Result<bool>) -> Result<()> {
        loop {
            let before = self.lexer;
            match self.lexer.next()? {
                Token::Sign(b')') => return Ok(()),
                Token::Sign(b';' | b',') | Token::Text(_) => {}
                Token::Word("add" | "append" | "prepend" | "delete" | "reorder") => {}
                Token::Word(key) => {
                    if !self.lexer.sign(b'=') {
                        continue;
                    }
                    let value = self.lexer;
                    if !take(self, key)? {
                        self.lexer = value;
                        self.lexer.skip_value()?;
                    }
                }
                Token::End => return Err(before.wrong(Cause::End)),
                _ => return Err(before.expected(Wanted::Name)),
            }
        }
    }

    fn prim_metadata(&mut self, prim: &mut Prim<'a>) -> Result<()> {
        self.entries(&mut |stage, key| {
            match key {
                "displayName" => prim.display_name = unescaped(stage.lexer.text()?),
                "customData" => {
                    let mut role = String::new();
                    stage.dictionary(&mut |name, text| {
                        if name == "vides" {
                            role = unescaped(text);
                        }
                    })?;
                    prim.role = role;
                }
                "active" => prim.out |= stage.lexer.number()? == 0.0,
                _ if ARCS.contains(&key) => {
                    let off = stage.lexer.skip_value_is("false")?;
                    if !off {
                        stage.tell(key);
                    }
                }
                _ => return Ok(false),
            }
            Ok(true)
        })
    }

    fn layer_metadata(&mut self) -> Result<()> {
        self.entries(&mut |stage, key| {
            match key {
                "doc" | "documentation" => stage.doc = unescaped(stage.lexer.text()?),
                "upAxis" => stage.up = unescaped(stage.lexer.text()?),
                "metersPerUnit" => stage.metres = Some(stage.lexer.number()?),
                "startTimeCode" => stage.start = Some(stage.lexer.number()?),
                "endTimeCode" => stage.end = Some(stage.lexer.number()?),
                "timeCodesPerSecond" => stage.codes_per_second = Some(stage.lexer.number()?),
                "framesPerSecond" => stage.frames_per_second = Some(stage.lexer.number()?),
                "customLayerData" => {
                    let (mut title, mut camera, mut unit) = (String::new(), String::new(), None);
                    stage.dictionary(&mut |name, text| match name {
                        "title" => title = unescaped(text),
                        "camera" => camera = unescaped(text),
                        "unit" => unit = Some(unescaped(text)),
                        _ => {}
                    })?;
                    (stage.title, stage.camera, stage.unit) = (title, camera, unit);
                }
                _ if ARCS.contains(&key) => {
                    stage.lexer.skip_value()?;
                    stage.tell(key);
                }
                _ => return Ok(false),
            }
            Ok(true)
        })
    }

    /// The texts of a dictionary, by their names.
    fn dictionary(&mut self, take: &mut dyn FnMut(&'a str, &'a str)) -> Result<()> {
        self.lexer.need("{")?;
        loop {
            if self.lexer.sign(b'}') {
                return Ok(());
            }
            if self.lexer.sign(b';') || self.lexer.sign(b',') {
                continue;
            }
            let kind = self.lexer.word()?;
            let list = self.lexer.sign(b'[');
            if list {
                self.lexer.need("]")?;
            }
            let before = self.lexer;
            let (Token::Word(name) | Token::Text(name)) = self.lexer.next()? else {
                return Err(before.expected(Wanted::Name));
            };
            self.lexer.need("=")?;
            if kind == "string" && !list {
                take(name, self.lexer.text()?);
            } else {
                self.lexer.skip_value()?;
            }
        }
    }

    /// An attribute or a relationship, of which the first word was taken.
    fn property(&mut self, word: &'a str, prim: usize) -> Result<()> {
        let mut word = word;
        while matches!(
            word,
            "custom"
                | "uniform"
                | "varying"
                | "config"
                | "add"
                | "append"
                | "prepend"
                | "delete"
                | "reorder"
        ) {
            word = self.lexer.word()?;
        }
        if self.lexer.sign(b'[') {
            self.lexer.need("]")?;
        }
        let name = self.lexer.word()?;
        let field = if self.lexer.sign(b'.') {
            self.lexer.word()?
        } else {
            ""
        };
        let mut found = None;
        if self.lexer.sign(b'=') {
            found = Some(self.lexer.at());
            self.lexer.skip_value()?;
        }
        let mut interpolation = "";
        if self.lexer.sign(b'(') {
            self.entries(&mut |stage, key| {
                if key != "interpolation" {
                    return Ok(false);
                }
                interpolation = stage.lexer.text()?;
                Ok(true)
            })?;
        }
        if word == "rel" {
            self.prims[prim].skinned |= name == "skel:skeleton" && found.is_some();
            return Ok(());
        }
        let taken = name.starts_with("xformOp") || TAKEN.contains(&name);
        if !taken || self.prims[prim].out {
            return Ok(());
        }
        match (field, found) {
            ("" | "timeSamples", Some(at)) => {
                let attributes = &mut self.prims[prim].attributes;
                attributes.try_reserve(1)?;
                attributes.push(Attribute {
                    name,
                    at,
                    samples: field == "timeSamples",
                    interpolation,
                });
            }
            ("spline", Some(at)) => self.prims[prim].spline = Some(at),
            ("connect", Some(_)) => self.tell(field),
            _ => {}
        }
        Ok(())
    }
}

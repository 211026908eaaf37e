//! The words of a file, one after the other. What is not wanted is passed over without memory.

use std::iter::Peekable;
use std::str::Chars;

use crate::error::{Cause, Error, Place, Result, Wanted};

/// How deep brackets in a value may lie.
const MAX_BRACKETS: usize = 64;

/// A word of the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Token<'a> {
    /// Letters, digits, `_` and `:`.
    Word(&'a str),
    /// What begins as a number does.
    Number(&'a str),
    /// What stands between quotation marks, as it is written.
    Text(&'a str),
    /// `@…@`.
    Asset,
    /// `<…>`.
    Path,
    /// Any other sign.
    Sign(u8),
    /// The end of the file.
    End,
}

/// A place in the file from which words are taken.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lexer<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Lexer<'a> {
    pub(super) const fn new(text: &'a str) -> Self {
        Self { text, at: 0 }
    }

    /// The place reached, in bytes.
    pub(super) const fn at(&self) -> usize {
        self.at
    }

    /// The same file from another place on, which [`Lexer::at`] gave.
    pub(super) const fn from(&self, at: usize) -> Self {
        Self { at, ..*self }
    }

    /// The line of a place.
    pub(super) fn line(&self, at: usize) -> Place {
        let before = &self.text.as_bytes()[..at.min(self.text.len())];
        Place::Line(1 + before.iter().filter(|&&byte| byte == b'\n').count())
    }

    /// An error where it is.
    pub(super) fn wrong(&self, cause: Cause) -> Error {
        // The word that is meant may stand lines below.
        let mut ahead = *self;
        let _ = ahead.blanks();
        self.line(ahead.at).wrong(cause)
    }

    /// The same: something else is expected.
    pub(super) fn expected(&self, wanted: Wanted) -> Error {
        if self.peek() == Ok(Token::End) {
            return self.wrong(Cause::End);
        }
        self.wrong(Cause::Expected(wanted))
    }

    fn rest(&self) -> &'a [u8] {
        &self.text.as_bytes()[self.at..]
    }

    fn find(&self, from: usize, what: &str) -> Option<usize> {
        let found = self.text.get(from..)?.find(what)?;
        Some(from + found)
    }

    /// Passes over blanks and comments.
    fn blanks(&mut self) -> Result<(), Cause> {
        loop {
            let rest = self.rest();
            let blank = |byte: &u8| !byte.is_ascii_whitespace();
            self.at += rest.iter().position(blank).unwrap_or(rest.len());
            let rest = self.rest();
            if rest.starts_with(b"#") || rest.starts_with(b"//") {
                self.at = self.find(self.at, "\n").unwrap_or(self.text.len());
            } else if rest.starts_with(b"/*") {
                self.at = 2 + self.find(self.at + 2, "*/").ok_or(Cause::End)?;
            } else {
                return Ok(());
            }
        }
    }

    /// The next word, which stays the next.
    fn peek(&self) -> Result<Token<'a>, Cause> {
        self.clone().take()
    }

    /// The next word.
    ///
    /// # Errors
    /// [`Cause::End`] in a text or comment that does not end.
    pub(super) fn next(&mut self) -> Result<Token<'a>> {
        self.take().map_err(|cause| self.wrong(cause))
    }

    fn take(&mut self) -> Result<Token<'a>, Cause> {
        self.blanks()?;
        let (start, rest) = (self.at, self.rest());
        let Some(&first) = rest.first() else {
            return Ok(Token::End);
        };
        let mut run = |fits: &dyn Fn(u8) -> bool| {
            let length = rest.iter().position(|&byte| !fits(byte));
            self.at += length.unwrap_or(rest.len());
            &self.text[start..self.at]
        };
        let letter = |byte: u8| byte.is_ascii_alphabetic() || byte == b'_' || !byte.is_ascii();
        match first {
            b'0'..=b'9' | b'-' | b'+' | b'.' if first != b'.' || digit(rest.get(1)) => {
                let signs = |byte: u8| byte.is_ascii_alphanumeric() || b".+-".contains(&byte);
                Ok(Token::Number(run(&signs)))
            }
            _ if letter(first) => {
                let signs = |byte: u8| letter(byte) || byte.is_ascii_digit() || byte == b':';
                Ok(Token::Word(run(&signs)))
            }
            b'"' | b'\'' => self.quoted(first),
            b'@' => {
                let mark = if rest.starts_with(b"@@@") { "@@@" } else { "@" };
                let end = self.find(start + mark.len(), mark).ok_or(Cause::End)?;
                self.at = end + mark.len();
                Ok(Token::Asset)
            }
            b'<' => {
                self.at = 1 + self.find(start, ">").ok_or(Cause::End)?;
                Ok(Token::Path)
            }
            sign => {
                self.at += 1;
                Ok(Token::Sign(sign))
            }
        }
    }

    fn quoted(&mut self, mark: u8) -> Result<Token<'a>, Cause> {
        let three = [mark; 3];
        let (width, lines) = if self.rest().starts_with(&three) {
            (3, true)
        } else {
            (1, false)
        };
        let start = self.at + width;
        let bytes = self.text.as_bytes();
        let mut at = start;
        loop {
            match bytes.get(at) {
                None => return Err(Cause::End),
                Some(b'\\') => at += 2,
                Some(b'\n') if !lines => return Err(Cause::Expected(Wanted::Literal("\""))),
                Some(_) if bytes[at..].starts_with(&three[..width]) => break,
                Some(_) => at += 1,
            }
        }
        self.at = at + width;
        Ok(Token::Text(&self.text[start..at]))
    }

    /// Whether the next word is this sign, which is taken then.
    pub(super) fn sign(&mut self, sign: u8) -> bool {
        let mut ahead = *self;
        let found = ahead.take() == Ok(Token::Sign(sign));
        if found {
            *self = ahead;
        }
        found
    }

    /// Takes a sign.
    ///
    /// # Errors
    /// [`Wanted::Literal`], [`Cause::End`].
    pub(super) fn need(&mut self, sign: &'static str) -> Result<()> {
        if self.sign(sign.as_bytes()[0]) {
            return Ok(());
        }
        Err(self.expected(Wanted::Literal(sign)))
    }

    /// # Errors
    /// [`Wanted::Text`], [`Cause::End`].
    pub(super) fn text(&mut self) -> Result<&'a str> {
        let before = *self;
        match self.next()? {
            Token::Text(text) => Ok(text),
            _ => Err(before.expected(Wanted::Text)),
        }
    }

    /// # Errors
    /// [`Wanted::Name`], [`Cause::End`].
    pub(super) fn word(&mut self) -> Result<&'a str> {
        let before = *self;
        match self.next()? {
            Token::Word(word) => Ok(word),
            _ => Err(before.expected(Wanted::Name)),
        }
    }

    /// Passes over a value.
    ///
    /// # Errors
    /// [`Cause::Deep`], [`Cause::End`]; [`Wanted::Value`] if it is missing, or brackets that do not
    /// match.
    pub(super) fn skip_value(&mut self) -> Result<()> {
        let before = *self;
        match self.next()? {
            Token::Sign(open @ (b'(' | b'[' | b'{')) => self.skip_rest(open),
            Token::Asset | Token::Path => {
                // A place in the file, and a shift in time.
                let mut ahead = *self;
                if ahead.next()? == Token::Path {
                    *self = ahead;
                }
                if self.sign(b'(') {
                    self.skip_rest(b'(')?;
                }
                Ok(())
            }
            Token::Word(_) | Token::Number(_) | Token::Text(_) => Ok(()),
            Token::Sign(_) | Token::End => Err(before.expected(Wanted::Value)),
        }
    }

    /// Passes over a value and says whether it is this word.
    ///
    /// # Errors
    /// As [`Lexer::skip_value`].
    pub(super) fn skip_value_is(&mut self, word: &str) -> Result<bool> {
        let is = self.peek() == Ok(Token::Word(word));
        self.skip_value()?;
        Ok(is)
    }

    /// Passes over what follows an opening bracket, to the closing one.
    ///
    /// # Errors
    /// As [`Lexer::skip_value`].
    pub(super) fn skip_rest(&mut self, open: u8) -> Result<()> {
        let mut stack = [0; MAX_BRACKETS];
        stack[0] = open;
        let mut depth = 1;
        while depth > 0 {
            let before = *self;
            match self.next()? {
                Token::Sign(sign @ (b'(' | b'[' | b'{')) => {
                    let place = stack.get_mut(depth);
                    *place.ok_or_else(|| before.wrong(Cause::Deep))? = sign;
                    depth += 1;
                }
                Token::Sign(sign @ (b')' | b']' | b'}')) => {
                    depth -= 1;
                    // The closing ones stand one or two behind the opening ones.
                    if !(1..=2).contains(&(i16::from(sign) - i16::from(stack[depth]))) {
                        return Err(before.expected(Wanted::Value));
                    }
                }
                Token::End => return Err(before.wrong(Cause::End)),
                _ => {}
            }
        }
        Ok(())
    }

    /// Appends all numbers of a value, whatever its brackets; false if it is `None`.
    ///
    /// # Errors
    /// [`Wanted::Number`], [`Cause::Deep`], [`Cause::End`], [`Cause::NotFinite`]; for memory.
    pub(super) fn numbers(&mut self, out: &mut Vec<f64>) -> Result<bool> {
        let mut depth: usize = 0;
        loop {
            let before = *self;
            let number = match self.next()? {
                Token::Sign(b'(' | b'[') if depth < 4 => {
                    depth += 1;
                    continue;
                }
                Token::Sign(b'(' | b'[') => return Err(before.wrong(Cause::Deep)),
                Token::Sign(b')' | b']') if depth > 0 => {
                    depth -= 1;
                    if depth == 0 {
                        return Ok(true);
                    }
                    continue;
                }
                Token::Sign(b',') if depth > 0 => continue,
                Token::Word("None") if depth == 0 => return Ok(false),
                Token::Word("true" | "True") => 1.0,
                Token::Word("false" | "False") => 0.0,
                Token::Word(word) | Token::Number(word) => {
                    word.parse().map_err(|_| before.expected(Wanted::Number))?
                }
                _ => return Err(before.expected(Wanted::Number)),
            };
            if !f64::is_finite(number) {
                return Err(before.wrong(Cause::NotFinite));
            }
            out.try_reserve(1)?;
            out.push(number);
            if depth == 0 {
                return Ok(true);
            }
        }
    }

    /// One number.
    ///
    /// # Errors
    /// As [`Lexer::numbers`]; [`Cause::NumberCount`].
    pub(super) fn number(&mut self) -> Result<f64> {
        let before = *self;
        let mut numbers = Vec::new();
        self.numbers(&mut numbers)?;
        match numbers[..] {
            [number] => Ok(number),
            _ => Err(before.expected(Wanted::Number)),
        }
    }
}

fn digit(byte: Option<&u8>) -> bool {
    byte.is_some_and(u8::is_ascii_digit)
}

/// What a text between quotation marks says.
pub(super) fn unescaped(text: &str) -> String {
    let mut out = String::new();
    let mut signs = text.chars().peekable();
    while let Some(sign) = signs.next() {
        if sign != '\\' {
            out.push(sign);
            continue;
        }
        let meant = match signs.next() {
            Some('n') => '\n',
            Some('r') => '\r',
            Some('t') => '\t',
            Some('x') => code(&mut signs, 2, 16, 0),
            Some(octal @ '0'..='7') => code(&mut signs, 2, 8, octal.to_digit(8).unwrap_or(0)),
            Some(other) => other,
            None => break,
        };
        out.push(meant);
    }
    out
}

/// A character by its code: at most `most` digits after the first.
fn code(signs: &mut Peekable<Chars<'_>>, most: usize, radix: u32, first: u32) -> char {
    let mut code = first;
    for _ in 0..most {
        let Some(digit) = signs.peek().and_then(|sign| sign.to_digit(radix)) else {
            break;
        };
        signs.next();
        code = radix * code + digit;
    }
    char::from_u32(code).unwrap_or(char::REPLACEMENT_CHARACTER)
}

#[cfg(test)]
mod tests {
    use super::super::text::Quoted;
    use super::*;

    #[test]
    fn words_of_all_kinds() {
        let text = "# c\n/* d */ def a:b.c = -1.5e-3 .5 // e\n'x\\'y' \"\"\"z\n\"\"\" @a@ @@@b@c@@@ </d> ;";
        let mut lexer = Lexer::new(text);
        let words = std::iter::from_fn(|| Some(lexer.next().unwrap()).filter(|t| *t != Token::End));
        let wanted = [
            Token::Word("def"),
            Token::Word("a:b"),
            Token::Sign(b'.'),
            Token::Word("c"),
            Token::Sign(b'='),
            Token::Number("-1.5e-3"),
            Token::Number(".5"),
            Token::Text("x\\'y"),
            Token::Text("z\n"),
            Token::Asset,
            Token::Asset,
            Token::Path,
            Token::Sign(b';'),
        ];
        assert_eq!(words.collect::<Vec<_>>(), wanted);
    }

    #[test]
    fn texts_lead_back() {
        for text in ["", "a\"b\\c\n\r\t\u{1}\u{7f}é\\n", "\\x41", "'"] {
            let quoted = Quoted(text).to_string();
            let mut lexer = Lexer::new(&quoted);
            assert_eq!(unescaped(lexer.text().unwrap()), text);
            assert_eq!(lexer.next().unwrap(), Token::End);
        }
        assert_eq!(unescaped("\\101\\x4a\\q\\"), "AJq");
    }

    #[test]
    fn brackets_must_match_and_lie_shallow() {
        let said = |text: &str| Lexer::new(text).skip_value().unwrap_err().to_string();
        assert_eq!(said("(\n1]"), "line 2: expected a value");
        assert_eq!(said("[1, 2"), "line 1: the file ends too early");
        assert_eq!(
            said(&"(".repeat(65)),
            "line 1: this lies deeper than is taken"
        );
        assert_eq!(said("'a"), "line 1: the file ends too early");
        assert_eq!(said("'a\nb'"), "line 1: expected \"\"\"");
        Lexer::new("{ string a = ')' }").skip_value().unwrap();
    }

    #[test]
    fn numbers_in_any_brackets() {
        let read = |text: &str| {
            let mut out = Vec::new();
            let there = Lexer::new(text).numbers(&mut out);
            there
                .map(|there| there.then_some(out))
                .map_err(|error| error.to_string())
        };
        assert_eq!(
            read("[(1, 2.5), (-3e1, true)]"),
            Ok(Some(vec![1.0, 2.5, -30.0, 1.0]))
        );
        assert_eq!(read("None"), Ok(None));
        assert_eq!(read("7 8"), Ok(Some(vec![7.0])));
        assert_eq!(read("[]"), Ok(Some(vec![])));
        assert_eq!(
            read("(1, inf)").unwrap_err(),
            "line 1: the number must be finite"
        );
        assert_eq!(read("(1,\n abc)").unwrap_err(), "line 2: expected a number");
        assert_eq!(read("(1,").unwrap_err(), "line 1: the file ends too early");
    }
}

//! The tokens of a file, which `toml_parser` finds, with a look at those that come.

use toml_parser::lexer::{Lexer, Token, TokenKind};
use toml_parser::{ParseError, Raw, Source, Span};

use crate::error::Error;

/// Why a text cannot be read; None: it is no TOML.
pub(super) type Stop = Option<Error>;

pub(super) struct Tokens<'a> {
    pub(super) text: &'a str,
    lexer: Lexer<'a>,
    /// Tokens that have been looked at.
    ahead: [Option<Token>; 2],
    /// The end of the last token, and the beginning of its line.
    pub(super) at: usize,
    pub(super) line: usize,
}

impl<'a> Tokens<'a> {
    pub(super) fn of(text: &'a str) -> Self {
        // A byte order mark is no token.
        let begin = if text.starts_with('\u{feff}') { 3 } else { 0 };
        Self {
            text,
            lexer: Source::new(text).lex(),
            ahead: [None; 2],
            at: begin,
            line: begin,
        }
    }

    /// Where the next token ends.
    pub(super) fn end_of_next(&mut self) -> usize {
        self.look(0);
        self.ahead[0].map_or(self.text.len(), |token| token.span().end())
    }

    /// The kind of a token to come.
    pub(super) fn look(&mut self, at: usize) -> TokenKind {
        for place in &mut self.ahead[..=at] {
            *place = place.or_else(|| self.lexer.next());
        }
        self.ahead[at].map_or(TokenKind::Eof, |token| token.kind())
    }

    /// The kind of the next token.
    pub(super) fn kind(&mut self) -> TokenKind {
        self.look(0)
    }

    /// Where the next token begins.
    pub(super) fn offset(&mut self) -> usize {
        self.look(0);
        self.ahead[0].map_or(self.text.len(), |token| token.span().start())
    }

    /// Passes a token; where it stands.
    pub(super) fn next(&mut self) -> Span {
        self.look(0);
        let [first, second] = self.ahead;
        self.ahead = [second, None];
        let end = Span::new_unchecked(self.text.len(), self.text.len());
        let span = first.map_or(end, |token| token.span());
        self.at = span.end();
        span
    }

    /// Whether the next token is of this kind, which is passed then.
    pub(super) fn takes(&mut self, kind: TokenKind) -> bool {
        let there = self.kind() == kind;
        if there {
            self.next();
        }
        there
    }

    /// Passes the next token, which must be of this kind.
    pub(super) fn wants(&mut self, kind: TokenKind) -> Result<(), Stop> {
        self.takes(kind).then_some(()).ok_or(None)
    }

    /// The token at this place.
    pub(super) fn raw(&self, span: Span, kind: TokenKind) -> Raw<'a> {
        let text = self.text.get(span.start()..span.end());
        Raw::new_unchecked(text.unwrap_or(""), kind.encoding(), span)
    }

    /// Passes a comment.
    pub(super) fn comment(&mut self) -> Result<&'a str, Stop> {
        let span = self.next();
        let (raw, mut wrong) = (self.raw(span, TokenKind::Comment), None::<ParseError>);
        raw.decode_comment(&mut wrong);
        match wrong {
            None => Ok(raw.as_str()),
            Some(_) => Err(None),
        }
    }

    /// Passes the end of a line.
    pub(super) fn newline(&mut self) -> Result<(), Stop> {
        let span = self.next();
        self.line = self.at;
        // A carriage return alone is none.
        match self.raw(span, TokenKind::Newline).as_str() {
            "\r" => Err(None),
            _ => Ok(()),
        }
    }

    /// Passes a value without brackets; numbers with a point and dates are of several tokens.
    pub(super) fn scalar(&mut self) -> (TokenKind, Span) {
        let kind = self.kind();
        let mut span = self.next();
        while kind.encoding().is_none() {
            match self.kind() {
                TokenKind::Atom | TokenKind::Dot => {}
                TokenKind::Whitespace if self.look(1) == TokenKind::Atom => {
                    self.next();
                }
                _ => break,
            }
            span = span.append(self.next());
        }
        (kind, span)
    }
}

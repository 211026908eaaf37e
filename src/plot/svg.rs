//! The part of SVG that plots need.

use std::fmt::Write;

/// Pixels to the right and down.
pub type Spot = (f64, f64);

pub struct Svg {
    text: String,
    pub width: f64,
    pub height: f64,
    pub ground: &'static str,
    /// What has been drawn, for other picture formats.
    pub marks: Vec<Mark>,
}

pub struct Mark {
    pub form: Form,
    pub attributes: String,
}

pub enum Form {
    Line(Vec<Spot>),
    /// Corner, width and height.
    Rectangle(Spot, f64, f64),
    Circle(Spot, f64),
    Text(Spot, Anchor, String),
}

/// Alignment of a text relative to its spot.
#[derive(Clone, Copy)]
pub enum Anchor {
    Start,
    Middle,
    End,
}

impl Svg {
    pub(super) fn new(width: f64, height: f64, title: &str, ground: &'static str) -> Self {
        let mut svg = Self {
            text: String::new(),
            width,
            height,
            ground,
            marks: Vec::new(),
        };
        svg.put(format_args!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" role=\"img\" \
             font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\" font-size=\"12.5\" \
             fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">"
        ));
        svg.put(format_args!("<title>{}</title>", escaped(title)));
        svg.put(format_args!(
            "<rect width=\"{width}\" height=\"{height}\" fill=\"{ground}\"/>"
        ));
        svg
    }

    pub(super) fn finish(mut self) -> String {
        self.text.push_str("</svg>\n");
        self.text
    }

    fn put(&mut self, line: std::fmt::Arguments<'_>) {
        let _ = writeln!(self.text, "{line}");
    }

    fn mark(&mut self, form: Form, attributes: &str) {
        let attributes = attributes.to_owned();
        self.marks.push(Mark { form, attributes });
    }

    /// Groups what `draw` draws, with attributes for all of it.
    pub(super) fn group(&mut self, id: &str, attributes: &str, draw: impl FnOnce(&mut Self)) {
        self.put(format_args!("<g id=\"{id}\" {attributes}>"));
        draw(self);
        self.put(format_args!("</g>"));
    }

    pub(super) fn line(&mut self, (x1, y1): Spot, (x2, y2): Spot, attributes: &str) {
        self.mark(Form::Line(vec![(x1, y1), (x2, y2)]), attributes);
        self.put(format_args!(
            "<line x1=\"{x1:.2}\" y1=\"{y1:.2}\" x2=\"{x2:.2}\" y2=\"{y2:.2}\" {attributes}/>"
        ));
    }

    pub(super) fn polyline(&mut self, spots: &[Spot], attributes: &str) {
        self.mark(Form::Line(spots.to_vec()), attributes);
        let spots = listed(spots);
        self.put(format_args!("<polyline points=\"{spots}\" {attributes}/>"));
    }

    pub(super) fn rectangle(&mut self, (x, y): Spot, width: f64, height: f64, attributes: &str) {
        self.mark(Form::Rectangle((x, y), width, height), attributes);
        self.put(format_args!(
            "<rect x=\"{x:.2}\" y=\"{y:.2}\" width=\"{width:.2}\" height=\"{height:.2}\" {attributes}/>"
        ));
    }

    pub(super) fn circle(&mut self, (x, y): Spot, radius: f64, attributes: &str) {
        self.mark(Form::Circle((x, y), radius), attributes);
        self.put(format_args!(
            "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius:.2}\" {attributes}/>"
        ));
    }

    pub(super) fn text(&mut self, (x, y): Spot, anchor: Anchor, text: &str, attributes: &str) {
        self.mark(Form::Text((x, y), anchor, text.to_owned()), attributes);
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        self.put(format_args!(
            "<text x=\"{x:.2}\" y=\"{y:.2}\" text-anchor=\"{anchor}\" {attributes}>{}</text>",
            escaped(text)
        ));
    }
}

fn listed(spots: &[Spot]) -> String {
    let mut list = String::new();
    for (x, y) in spots {
        let _ = write!(list, "{x:.2},{y:.2} ");
    }
    list.truncate(list.trim_end().len());
    list
}

/// Escapes a text for XML and replaces the characters that XML does not allow.
fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for character in text.chars() {
        match character {
            '<' => escaped.push_str("&lt;"),
            '&' => escaped.push_str("&amp;"),
            '>' => escaped.push_str("&gt;"),
            '\u{fffe}' | '\u{ffff}' => escaped.push('\u{fffd}'),
            control if control.is_control() => escaped.push('\u{fffd}'),
            other => escaped.push(other),
        }
    }
    escaped
}

/// Usual width of a letter, in pixels.
const LETTER: f64 = 6.4;

/// Cuts a text to a width in pixels, assuming letters of [`LETTER`].
pub(super) fn cut(text: &str, width: f64) -> String {
    let room = (width / LETTER) as usize;
    if text.chars().count() <= room {
        return text.to_owned();
    }
    let kept: String = text.chars().take(room.saturating_sub(1)).collect();
    format!("{}…", kept.trim_end())
}

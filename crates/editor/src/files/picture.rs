//! A small picture of a path in a file.

use std::path::Path;

use egui::{Align2, Pos2, Rect, Sense, Shape, Stroke, Ui, Vec2, WidgetInfo, pos2};

use crate::document::mesh::Format;
use crate::document::{Document, load_object};
use crate::setup::Element;
use crate::space;
use crate::state::Editor;
use crate::theme;

/// A longer file is not read for its picture alone.
const LONGEST: u64 = 1 << 20;

/// The edges of the movement space, the curve, and what is to be seen there.
#[derive(Debug)]
pub(crate) struct Picture {
    edges: Vec<[Pos2; 2]>,
    curve: Vec<Pos2>,
    things: Vec<[Pos2; 2]>,
    /// A scene without an edited path.
    of_scene: bool,
}

impl Picture {
    pub(super) fn of(document: &Document, size: Vec2) -> Self {
        let (edges, curve) = space::thumbnail(document, size);
        let scene = space::thumbnail_of_scene(document, size);
        Self {
            edges,
            curve,
            of_scene: scene.is_some(),
            things: scene.unwrap_or_else(|| space::thumbnail_of_object(document, size)),
        }
    }

    /// The picture of a file; `None` if it is long, or no path, scene or mesh.
    pub(super) fn of_file(file: &Path, size: Vec2) -> Option<Self> {
        let known = std::fs::metadata(file).ok()?;
        let short = known.is_file() && known.len() <= LONGEST;
        let of_scene = || Some(Document::load_scene(file).ok()?.0);
        let load = || match Format::of(file) {
            Some(_) => Document::around(load_object(file).ok()?).ok(),
            None => Document::load(file).ok().or_else(of_scene),
        };
        let document = short.then(load)??;
        let mut picture = Self::of(&document, size);
        if Format::of(file).is_some() {
            picture.curve.clear();
        }
        Some(picture)
    }

    pub(crate) fn paint(&self, editor: &Editor, ui: &Ui, rect: Rect) {
        let colours = editor.setup.colours();
        let painter = ui.painter_at(rect);
        let at = |point: &Pos2| pos2(rect.left() + point.x, rect.top() + point.y);
        let faint = colours.of(Element::Cube).gamma_multiply(0.5);
        for [from, to] in &self.edges {
            painter.line_segment([at(from), at(to)], Stroke::new(1.0, faint));
        }
        let object = Stroke::new(1.0, colours.of(Element::Object));
        for [from, to] in &self.things {
            painter.line_segment([at(from), at(to)], object);
        }
        let line = Stroke::new(1.5, colours.of(Element::Curve));
        painter.add(Shape::line(self.curve.iter().map(at).collect(), line));
    }
}

/// Shows it, or a question mark where there is none.
pub(super) fn show(editor: &Editor, ui: &mut Ui, size: Vec2, picture: Option<&Picture>) {
    let texts = &editor.texts().recovery;
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    let ground = editor.setup.colours().of(Element::Background);
    ui.painter().rect_filled(rect, 4.0, ground);
    let name = if let Some(picture) = picture {
        picture.paint(editor, ui, rect);
        match picture.of_scene {
            true => texts.scene,
            false => texts.picture,
        }
    } else {
        let color = theme::palette(ui).error;
        let (centre, font) = (rect.center(), theme::text());
        ui.painter()
            .text(centre, Align2::CENTER_CENTER, "?", font, color);
        texts.unreadable
    };
    response.widget_info(|| WidgetInfo::labeled(egui::Role::Image, true, name));
    response.on_hover_text(name);
}

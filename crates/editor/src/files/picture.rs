//! Small pictures of paths: of those in files, and of others that could be.

use std::cell::RefCell;
use std::path::Path;

use egui::{Align2, Context, Pos2, Rect, Sense, Shape, Stroke, Ui, Vec2, WidgetInfo};
use vides_document::mesh::Format;
use vides_document::{Document, load_object};
use vides_engine::tools::fit::Progress;

use crate::background::Background;
use crate::setup::Element;
use crate::state::Editor;
use crate::state::files::{Made, Picture, Pictures};
use crate::{space, theme};

/// A longer file is not read for its picture alone.
const LONGEST: u64 = 1 << 20;

impl Picture {
    pub(crate) fn of(document: &Document, size: Vec2) -> Self {
        let (edges, curve) = space::thumbnail(document, size);
        let scene = space::thumbnail_of_scene(document, size);
        Self {
            size,
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
        let picture = Self::of(&document, size);
        Some(match Format::of(file) {
            Some(_) => picture.without_path(),
            None => picture,
        })
    }

    /// Object and path alone, as large as they fit.
    pub(crate) fn closely(self) -> Self {
        let all = self.things.iter().flatten().chain(&self.curve);
        let mut bounds = Rect::NOTHING;
        all.for_each(|point| bounds.extend_with(*point));
        let (from, size) = (bounds.center(), self.size);
        let scale = ((size - Vec2::splat(6.0)) / bounds.size().max(Vec2::splat(1.0))).min_elem();
        let at = |point: Pos2| (scale * (point - from) + 0.5 * size).to_pos2();
        Self {
            size,
            edges: Vec::new(),
            curve: self.curve.into_iter().map(at).collect(),
            things: self.things.into_iter().map(|ends| ends.map(at)).collect(),
            of_scene: self.of_scene,
        }
    }

    pub(crate) fn without_path(self) -> Self {
        Self {
            curve: Vec::new(),
            ..self
        }
    }

    pub(crate) fn has_path(&self) -> bool {
        !self.curve.is_empty()
    }

    /// Paints it as large as fits into a rectangle, with a camera at a fraction of the path.
    pub(crate) fn paint(&self, editor: &Editor, ui: &Ui, rect: Rect, way: Option<f32>) {
        let colours = editor.setup.colours();
        let painter = ui.painter_at(rect);
        let scale = (rect.size() / self.size).min_elem();
        let at = |point: &Pos2| rect.center() + scale * (point.to_vec2() - 0.5 * self.size);
        let faint = colours.of(Element::Cube).gamma_multiply(0.5);
        for [from, to] in &self.edges {
            painter.line_segment([at(from), at(to)], Stroke::new(1.0, faint));
        }
        let object = Stroke::new(1.0, colours.of(Element::Object));
        for [from, to] in &self.things {
            painter.line_segment([at(from), at(to)], object);
        }
        let colour = colours.of(Element::Curve);
        let line = Stroke::new(1.5, colour);
        painter.add(Shape::line(self.curve.iter().map(at).collect(), line));
        let last = self.curve.len().saturating_sub(1) as f32;
        if let Some(place) = way.and_then(|way| self.curve.get((way * last).round() as usize)) {
            painter.circle_filled(at(place), 3.0, colour);
        }
    }
}

impl<K> Default for Pictures<K> {
    fn default() -> Self {
        Self(RefCell::new(None))
    }
}

impl<K: Clone + PartialEq + Send + 'static> Pictures<K> {
    /// Shows one of those that `make` makes, if it is there by now.
    pub(crate) fn show(
        &self,
        (editor, context): (&Editor, &Context),
        of: &K,
        make: fn(K, Progress<'_>) -> Vec<Option<Picture>>,
        (at, show): (usize, impl FnOnce(&Picture)),
    ) {
        let mut known = self.0.borrow_mut();
        if known.as_ref().is_none_or(|made| made.of != *of) {
            let mine = of.clone();
            let work =
                Background::begin_for_later(editor.start, move |go_on| Ok(make(mine, go_on)));
            *known = Some(Made {
                of: of.clone(),
                work,
                pictures: Vec::new(),
            });
        }
        let Some(made) = &mut *known else { return };
        if made.pictures.is_empty() && made.work.is_done(context) {
            // Without them there are names and signs.
            made.pictures = made.work.made().and_then(Result::ok).unwrap_or_default();
        }
        if let Some(Some(picture)) = made.pictures.get(at) {
            show(picture);
        }
    }
}

/// Shows it, or a question mark.
pub(super) fn show(editor: &Editor, ui: &mut Ui, size: Vec2, picture: Option<&Picture>) {
    let texts = &editor.texts().recovery;
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    let ground = editor.setup.colours().of(Element::Background);
    ui.painter().rect_filled(rect, 4.0, ground);
    let name = if let Some(picture) = picture {
        picture.paint(editor, ui, rect, None);
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

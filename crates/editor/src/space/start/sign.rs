//! What a beginning looks like: drawn on the object that is loaded, else as a sign.

use egui::{Color32, Painter, Pos2, Shape, Stroke, vec2};
use vides_document::error::Result;
use vides_document::tool;
use vides_document::tool::ToolInput;
use vides_document::{Document, Info};
use vides_engine::tools::fit::Progress;

use super::{Begin, TOOLS};
use crate::files::recent::PICTURE;
use crate::state::Editor;
use crate::state::files::Picture;
use crate::state::space::Around;

/// An object of more triangles has no picture of what takes long.
const MOST: usize = 100_000;

impl PartialEq for Around {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq::<[_]>(&*self.0, &*other.0) && self.1.space == other.1.space
    }
}

impl Around {
    /// `None` where nothing is loaded, and where there is no memory for it.
    pub(super) fn of(editor: &Editor) -> Option<Self> {
        let object = &editor.document.info().object;
        let path = editor.document.path().try_clone();
        (!object.is_empty()).then_some(Self(object.clone(), path.ok()?))
    }

    /// The object, with what a tool would make without settings.
    fn picture(&self, name: &str, go_on: Progress<'_>) -> Result<Option<Picture>> {
        let info = Info {
            object: self.0.clone(),
            ..Info::default()
        };
        let mut document = Document::from_parts(self.1.try_clone()?, info)?.without_history();
        let faces = self.0.mesh().map_or(0, |mesh| mesh.triangles.len());
        let tool = tool::tools().find(|tool| tool.name == name);
        let slow = |tool: &tool::Tool| tool.takes_long(&document, &ToolInput::None, &[]);
        let Some(tool) = tool.filter(|tool| !slow(tool) || faces <= MOST) else {
            return Ok(None);
        };
        let numbers = tool.defaults(&document)?;
        let made = tool.edit(&document, &ToolInput::None, &numbers, go_on)?;
        let edit = made.edit;
        let nothing = edit.is_none();
        if let Some(edit) = edit {
            document.apply(edit)?;
        }
        let picture = Picture::of(&document, PICTURE);
        let picture = if nothing {
            picture.without_path()
        } else {
            picture
        };
        Ok(Some(picture.closely()))
    }
}

/// Pictures of the tools' beginnings; what cannot be made has its sign.
pub(super) fn pictures(around: Around, go_on: Progress<'_>) -> Vec<Option<Picture>> {
    let pictures = TOOLS
        .iter()
        .map(|name| around.picture(name, go_on).ok().flatten());
    pictures.collect()
}

/// Recorded poses as dots; the one at a fraction of them is larger.
fn recording(painter: &Painter, at: Pos2, color: Color32, way: Option<f32>) {
    let near = way.map(|way| (way * 7.0) as u8);
    for step in 0..=6_u8 {
        let x = f32::from(step) * 5.0 - 15.0;
        let radius = if near == Some(step) { 3.2 } else { 1.8 };
        painter.circle_filled(at + vec2(x, 5.0 * (x / 6.0).sin()), radius, color);
    }
}

/// A small sign of a beginning around `at`; a camera is at a fraction of the path.
pub(super) fn paint(painter: &Painter, begin: Begin, at: Pos2, color: Color32, way: Option<f32>) {
    let stroke = Stroke::new(1.5, color);
    let line = |points: &[[f32; 2]]| {
        let points = points.iter().map(|&[x, y]| at + vec2(x, y)).collect();
        painter.add(Shape::line(points, stroke));
    };
    let flown = |points: &[[f32; 2]]| {
        line(points);
        if let (Some(way), Some(last)) = (way, points.len().checked_sub(1)) {
            let along = way * last as f32;
            let from = points[(along as usize).min(last)];
            let to = points[(along as usize + 1).min(last)];
            let [x, y] = [0, 1].map(|k| from[k] + along.fract() * (to[k] - from[k]));
            painter.circle_filled(at + vec2(x, y), 3.0, color);
        }
    };
    let thing = |x: f32, y: f32| {
        let corners = [vec2(0.0, -4.5), vec2(4.5, 4.0), vec2(-4.5, 4.0)];
        let corners = corners.map(|corner| at + vec2(x, y) + corner).to_vec();
        painter.add(Shape::convex_polygon(corners, color, Stroke::NONE));
    };
    let round = |wide: f32, high: f32, turns: f32| {
        let points: Vec<[f32; 2]> = (0..=32_u8)
            .map(|step| {
                let share = f32::from(step) / 32.0;
                let (sine, cosine) = (std::f32::consts::TAU * turns * share + 0.6).sin_cos();
                [wide * cosine, high * sine]
            })
            .collect();
        flown(&points);
    };
    match begin {
        Begin::Open => {
            line(&[
                [-10.0, 7.0],
                [-10.0, -6.0],
                [-4.0, -6.0],
                [-2.0, -3.0],
                [9.0, -3.0],
            ]);
            line(&[
                [9.0, -3.0],
                [9.0, 7.0],
                [-10.0, 7.0],
                [-6.0, 1.0],
                [13.0, 1.0],
                [9.0, 7.0],
            ]);
        }
        Begin::Example => {
            thing(0.0, 3.0);
            flown(&[
                [-15.0, 6.0],
                [-11.0, -2.0],
                [0.0, -8.0],
                [11.0, -2.0],
                [15.0, 6.0],
            ]);
        }
        Begin::Recording => recording(painter, at, color, way),
        Begin::View => {
            line(&[
                [-9.0, -6.0],
                [4.0, -6.0],
                [4.0, 6.0],
                [-9.0, 6.0],
                [-9.0, -6.0],
            ]);
            line(&[[4.0, 0.0], [11.0, -5.0], [11.0, 5.0], [4.0, 0.0]]);
        }
        Begin::Tool(tool) => match tool.name {
            "flyby" => {
                thing(0.0, 3.0);
                flown(&[[-16.0, -8.0], [14.0, -8.0]]);
                line(&[[10.0, -11.0], [15.0, -8.0], [10.0, -5.0]]);
            }
            "draw" => {
                let wave: Vec<[f32; 2]> = (0..=24_u8)
                    .map(|step| {
                        let x = f32::from(step) * 1.25 - 15.0;
                        [x, 6.0 * (x / 5.0).sin()]
                    })
                    .collect();
                flown(&wave);
            }
            "tour" => {
                thing(-6.0, 1.0);
                thing(7.0, 1.0);
                round(16.0, 9.0, 0.92);
            }
            _ => {
                thing(0.0, 0.0);
                round(15.0, 8.0, 0.92);
            }
        },
    }
}

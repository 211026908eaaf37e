//! Objects with faces, shaded: flat, by the scene's lights or one at the viewer, what is hidden left
//! out. Rebuilt only where
//! something else is seen; while the view moves, coarser.

use std::sync::Arc;

use egui::{Color32, Context, Pos2, Rect, lerp};
use glam::{DAffine3, DVec3, DVec4, Vec4Swizzles};
use vides_engine::scene::{Kind, Mesh};
use vides_raster::{Area, Corner3, Surfaces};

use super::lamps;
use super::strokes::part_between;
use crate::scene_view::wires::{Seen, each_object};
use crate::setup::Element;
use crate::space::nodes::colour as wire_colour;
use crate::state::Editor;
use crate::state::scene_view::Now;
use crate::state::space::solid::{Eye, Key, Sight, Solid};

/// After this time without a change, in seconds, it is made as well as can be.
const REST: f64 = 0.3;

/// More pixels are not smoothed, nor where a point has two of them.
const SMOOTHED: f64 = 2.5e6;

impl Eye {
    fn corner(&self, at: DVec4) -> Corner3 {
        (at.xyz() / at.w).to_array()
    }

    /// The two ends of a line before the viewer, and where they are in parts of its length.
    fn ends(&self, from: DVec3, to: DVec3) -> Option<[(f64, DVec4); 2]> {
        let [a, b] = [from, to].map(|end| self.matrix * end.extend(1.0));
        let (near, far) = (a.w - self.front, b.w - self.front);
        let crossing = near / (near - far);
        match (near >= 0.0, far >= 0.0) {
            (true, true) => Some([(0.0, a), (1.0, b)]),
            (true, false) => Some([(0.0, a), (crossing, a.lerp(b, crossing))]),
            (false, true) => Some([(crossing, a.lerp(b, crossing)), (1.0, b)]),
            (false, false) => None,
        }
    }
}

impl PartialEq for Sight {
    fn eq(&self, other: &Self) -> bool {
        self.number == other.number
    }
}

impl Sight {
    /// Divides a line into the parts that are seen and those behind faces: from where to where, in
    /// parts of its length, and whether it is hidden there.
    pub(super) fn parts(&self, from: DVec3, to: DVec3, mut take: impl FnMut(f64, f64, bool)) {
        let Some([(first, a), (last, b)]) = self.eye.ends(from, to) else {
            return take(0.0, 1.0, false);
        };
        let [start, end] = [a, b].map(|at| DVec3::from_array(self.eye.corner(at)));
        // What is even on the screen is less so in space.
        let along = |share: f64| {
            let (near, far) = ((1.0 - share) / a.w, share / b.w);
            first + (last - first) * far / (near + far)
        };
        let area = self.surfaces.area();
        let [left, top] = [area.x, area.y].map(f64::from);
        let low = DVec3::new(left, top, f64::NEG_INFINITY);
        let high = DVec3::new(
            left + f64::from(area.width),
            top + f64::from(area.height),
            f64::INFINITY,
        );
        let Some([enter, leave]) = part_between(start, end, low, high) else {
            return take(0.0, 1.0, false);
        };
        let length = (end - start).truncate().length() * (leave - enter);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let steps = (length / 1.5).ceil().clamp(1.0, 8192.0) as u32;
        let hidden = |step: u32| {
            let share = lerp(enter..=leave, (f64::from(step) + 0.5) / f64::from(steps));
            self.hides_corner(start.lerp(end, share).to_array())
        };
        let (mut since, mut was) = (0.0, enter == 0.0 && hidden(0));
        for step in 0..=steps {
            let is = step < steps && hidden(step);
            if is != was {
                let here = along(lerp(enter..=leave, f64::from(step) / f64::from(steps)));
                // At the end of all it may go on hidden.
                let here = if step == steps && leave == 1.0 {
                    1.0
                } else {
                    here
                };
                if here > since {
                    take(since, here, was);
                }
                (since, was) = (here, is);
            }
        }
        if since < 1.0 {
            take(since, 1.0, was);
        }
    }

    /// Whether a place lies behind a face.
    pub(super) fn hides(&self, place: DVec3) -> bool {
        let at = self.eye.matrix * place.extend(1.0);
        at.w >= self.eye.front && self.hides_corner(self.eye.corner(at))
    }

    /// The place on a face that is seen at a position of the screen, in points. For parallel
    /// projections.
    pub(super) fn place(&self, at: Pos2) -> Option<DVec3> {
        let [x, y] = [at.x, at.y].map(|at| f64::from(at) * self.eye.pixels_per_point);
        let near = self.surfaces.nearness([x, y])?;
        let place = self
            .eye
            .matrix
            .inverse()
            .project_point3(DVec3::new(x, y, near));
        place.is_finite().then_some(place)
    }

    fn hides_corner(&self, [x, y, near]: Corner3) -> bool {
        let [plain, share] = self.eye.slack;
        self.surfaces.hides([x, y, near + plain + share * near])
    }
}

impl Solid {
    /// What is seen now; none if no faces are to be seen.
    pub(super) fn update(
        &mut self,
        editor: &Editor,
        context: &Context,
        eye: Eye,
    ) -> Option<&Sight> {
        let setup = &editor.setup;
        if setup.wireframe || !setup.shown.has(Element::Object) {
            *self = Self {
                number: self.number,
                ..Self::default()
            };
            return None;
        }
        let object = &editor.document.info().object;
        // Without memory an object is merely not there.
        let scene = editor.with_scene(|now| (now.made_of.0, states(now, eye.of_path)));
        let key = Key {
            eye,
            colours: [Element::Background, Element::Object].map(|of| setup.colours().of(of)),
            object: object.mesh().map_or(std::ptr::null(), std::ptr::from_ref),
            scene: scene.ok().flatten(),
        };
        let time = context.input(|input| input.time);
        let other = self.made.as_ref() != Some(&key);
        let rests = time - self.changed >= REST;
        if other || (self.quick && rests) {
            // The first one has all the time that it needs, as have those that come rarely.
            let quick = other && self.made.is_some() && !rests;
            if other {
                self.changed = time;
            }
            self.object = object.clone();
            self.quick = self.make(editor, &key, quick);
            self.made = Some(key);
        }
        if self.quick {
            context.request_repaint_after(std::time::Duration::from_secs_f64(REST));
        }
        self.sight.as_ref()
    }

    /// Makes the picture; whether it could be better.
    fn make(&mut self, editor: &Editor, key: &Key, quick: bool) -> bool {
        let eye = &key.eye;
        self.number += 1;
        self.sight = None;
        let mut images: Vec<DVec4> = Vec::new();
        let mut bounds = Rect::NOTHING;
        let mut many = false;
        each(editor, eye.of_path, |seen| {
            many |= seen.drawn.faces(seen.mesh, true).len() != seen.mesh.triangles.len();
            if seen.mesh.triangles.is_empty() {
                return;
            }
            for &point in seen.points {
                let at = eye.matrix * seen.world.transform_point3(point).extend(1.0);
                if at.w < eye.front {
                    bounds = Rect::EVERYTHING;
                    break;
                }
                let [x, y, _] = eye.corner(at).map(|part| part as f32);
                bounds.extend_with(egui::pos2(x, y));
            }
        });
        let pixels = (eye.rect * eye.pixels_per_point as f32).intersect(bounds.expand(2.0));
        if !pixels.is_positive() {
            return false;
        }
        let [x, y] = [pixels.left(), pixels.top()].map(|at| at.floor().max(0.0) as u32);
        let area = Area {
            x,
            y,
            width: (pixels.right().ceil().max(0.0) as u32).saturating_sub(x),
            height: (pixels.bottom().ceil().max(0.0) as u32).saturating_sub(y),
        };
        let smooth = eye.pixels_per_point < 2.0 && f64::from(pixels.area()) < SMOOTHED;
        let Ok(mut surfaces) = Surfaces::new(area, smooth && !quick) else {
            return false;
        };
        let lamps = editor.with_scene(|now| lamps::lamps(now, into(now, eye.of_path)));
        let lamps = lamps.ok().flatten().unwrap_or_default();
        each(editor, eye.of_path, |seen| {
            images.clear();
            if images.try_reserve(seen.points.len()).is_err() {
                return;
            }
            let place = |point: DVec3| seen.world.transform_point3(point);
            images.extend(
                seen.points
                    .iter()
                    .map(|&p| eye.matrix * place(p).extend(1.0)),
            );
            let (ground, base) = (key.colours[0], wire_colour(seen.colour, key.colours[1]));
            let faces = seen.drawn.faces(seen.mesh, quick);
            for &triangle in faces {
                let corners = triangle.map(|at| place(seen.points[at as usize]));
                let lit = |turned: bool| {
                    let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
                    let normal = normal.normalize_or_zero() * if turned { -1.0 } else { 1.0 };
                    let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
                    lamps::lit(&lamps, middle, normal, of_viewer(eye, normal))
                };
                let own = own_colour(seen.mesh, triangle);
                let images = triangle.map(|at| images[at as usize]);
                before(eye, images, &mut |corners| {
                    let [a, b, c] = corners;
                    let turned = (b[0] - a[0]) * (c[1] - a[1]) > (c[0] - a[0]) * (b[1] - a[1]);
                    surfaces.triangle(corners, tone(ground, base, own, lit(turned) as f32));
                });
            }
        });
        if surfaces.settle().is_err() {
            return false;
        }
        let mut sight = Sight {
            eye: *eye,
            surfaces: Arc::new(surfaces),
            edges: Arc::default(),
            number: self.number,
        };
        let mut edges = Vec::new();
        each(editor, eye.of_path, |seen| {
            let place = |at: u32| seen.world.transform_point3(seen.points[at as usize]);
            for &[a, b] in seen.drawn.sharp(seen.mesh) {
                let [from, to] = [a, b].map(place);
                sight.parts(from, to, |start, end, hidden| {
                    if !hidden {
                        edges.push([from.lerp(to, start), from.lerp(to, end)]);
                    }
                });
            }
        });
        sight.edges = Arc::new(edges);
        self.sight = Some(sight);
        quick && (smooth || many)
    }
}

/// How bright the viewer's own lights make a face, in 0…1: the main one also reaches round, the weak
/// one tells apart what it leaves equal. What is seen of an object differs little in that, so it is
/// spread.
fn of_viewer(eye: &Eye, normal: DVec3) -> f64 {
    let [main, other] = eye.lights.map(|light| normal.dot(light));
    let light = 0.7 * (0.5 + 0.5 * main) + 0.3 * other.max(0.0);
    (0.5 + 2.5 * (light - 0.6)).clamp(0.0, 1.0)
}

/// All visible objects with meshes: the path's own, and those of the scene.
fn each(editor: &Editor, of_path: bool, mut take: impl FnMut(Seen<'_>)) {
    let edges = &mut editor.scene_view.edges.borrow_mut();
    let object = &editor.document.info().object;
    if let Some(mesh) = object.mesh() {
        take(Seen {
            mesh,
            points: &mesh.points,
            world: DAffine3::IDENTITY,
            colour: [1.0; 3],
            drawn: edges.of_object(object),
        });
    }
    let _ = editor.with_scene(|now| {
        let into = into(now, of_path);
        each_object(edges, now, |_, seen| {
            take(Seen {
                world: into * seen.world,
                ..seen
            })
        });
    });
}

/// From the world to the coordinates of the picture.
fn into(now: &Now, of_path: bool) -> DAffine3 {
    match of_path {
        true => now.into_path,
        false => DAffine3::IDENTITY,
    }
}

/// Where the objects and lights of a scene are, and how they look.
fn states(now: &Now, of_path: bool) -> Vec<f64> {
    let mut all = Vec::new();
    if of_path {
        all.extend(now.into_path.to_cols_array());
    }
    for (node, state) in now.scene.nodes().iter().zip(&now.states) {
        if !matches!(node.kind, Kind::Object(_) | Kind::Light(_)) {
            continue;
        }
        all.push(f64::from(u8::from(state.visible != 0)));
        all.extend(state.colour);
        all.extend(state.world().to_cols_array());
        let Kind::Object(object) = &node.kind else {
            // A light that aims is turned beside its matrix.
            all.extend(state.pose.vpn);
            all.extend([state.intensity, state.cone[0], state.cone[1]]);
            continue;
        };
        if !object.shapes().is_empty() || !object.deformations().is_empty() {
            all.push(now.frame);
        }
    }
    all
}

/// The part of a triangle before the viewer, as one triangle or two.
fn before(eye: &Eye, images: [DVec4; 3], take: &mut impl FnMut([Corner3; 3])) {
    if images.iter().all(|at| at.w >= eye.front) {
        return take(images.map(|at| eye.corner(at)));
    }
    // Sutherland and Hodgman 1974, for one plane.
    let mut cut = [Corner3::default(); 4];
    let mut count = 0;
    for (at, &from) in images.iter().enumerate() {
        let to = images[(at + 1) % 3];
        let [near, far] = [from, to].map(|end| end.w - eye.front);
        if near >= 0.0 {
            cut[count] = eye.corner(from);
            count += 1;
        }
        if (near < 0.0) != (far < 0.0) {
            cut[count] = eye.corner(from.lerp(to, near / (near - far)));
            count += 1;
        }
    }
    let [a, b, c, d] = cut;
    if count >= 3 {
        take([a, b, c]);
    }
    if count == 4 {
        take([a, c, d]);
    }
}

/// The colour of its points' middle, if they have any.
fn own_colour(mesh: &Mesh, triangle: [u32; 3]) -> Option<[f32; 3]> {
    let mut sum = [0.0; 3];
    for at in triangle {
        let colour = mesh.colours.get(at as usize)?;
        sum.iter_mut()
            .zip(colour)
            .for_each(|(sum, part)| *sum += f32::from(*part) / 3.0);
    }
    Some(sum)
}

/// The colour of a face that gets `lit` of the light, in 0…1: between the ground's and the
/// object's, and nearer to the ground's, so that the path stands out.
pub(super) fn tone(ground: Color32, base: Color32, own: Option<[f32; 3]>, lit: f32) -> Color32 {
    if let Some(own) = own {
        let share = 0.35 + 0.65 * lit;
        let [r, g, b] = own.map(|part| (part * share) as u8);
        return ground.lerp_to_gamma(Color32::from_rgb(r, g, b), 0.75);
    }
    let bright = |colour: Color32| colour.r() as u32 + colour.g() as u32 + colour.b() as u32;
    let share = match bright(base) > bright(ground) {
        true => 0.07 + 0.25 * lit,
        false => 0.19 - 0.17 * lit,
    };
    ground.lerp_to_gamma(base, share)
}

#[cfg(test)]
#[path = "solid_tests.rs"]
mod tests;

//! What lies under the pointer.

use glam::{DVec2, DVec3};
use vides_document::Document;
use vides_engine::path::ahead;

use super::drag::{VUP_LENGTH, current_tip};
use super::projection::Projection;
use super::tangents;
use crate::setup::{Element, Shown};
use crate::state::space::Handle;

/// How far from something the pointer may be to drag it, in points.
pub(super) const REACH: f64 = 6.0;

/// The current camera: position, unit view and up vectors, and the tips of its arrows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Tips {
    pub(super) position: DVec3,
    pub(super) view: DVec3,
    pub(super) up: DVec3,
    pub(super) target: DVec3,
    pub(super) up_tip: DVec3,
}

pub(super) fn tips(document: &Document) -> Option<Tips> {
    let selection = document.selection();
    let point = document.path().points.get(selection.point)?;
    let position = point.position;
    let path = document.path();
    let view = ahead::view(path, selection.point, selection.orientation);
    let space = path.space;
    let up = document.up(selection.point, selection.orientation).ok()?;
    Some(Tips {
        position,
        view,
        up,
        target: current_tip(document)?,
        up_tip: position + up * (VUP_LENGTH * space.half_size),
    })
}

/// What lies under `pointer`: the first within reach of VUP's tip (if `with_vup`), VPN's tip, the
/// tangents' ends, the current point and the nearest other one. A hidden tip is not taken, nor that
/// of an arrow which points at the viewer: it lies on its point, which is what is meant.
pub(super) fn pick(
    document: &Document,
    projection: &Projection,
    shown: &Shown,
    pointer: DVec2,
    with_vup: bool,
) -> Option<Handle> {
    if !document.edits_path() {
        return None;
    }
    let away = |point: DVec3| projection.image(point).distance_squared(pointer);
    let near = |point: DVec3| away(point) <= REACH * REACH;
    if let Some(tips) = tips(document) {
        let foot = projection.image(tips.position);
        let apart = |tip: DVec3| projection.image(tip).distance(foot) > REACH;
        let free = |tip: DVec3| near(tip) && apart(tip);
        if with_vup && shown.has(Element::Vup) && free(tips.up_tip) {
            return Some(Handle::Vup);
        }
        if shown.has(Element::Vpn) && free(tips.target) {
            return Some(Handle::Vpn);
        }
        if let Some((side, _)) = tangents::tips(document).find(|&(_, tip)| free(tip)) {
            return Some(Handle::Tangent(side));
        }
        if near(tips.position) {
            return Some(Handle::Point(document.selection().point));
        }
    }
    let points = document.path().points.iter();
    nearest(projection, points.map(|point| point.position), pointer).map(Handle::Point)
}

/// The nearest place within reach of the pointer, the first of several at one place.
pub(super) fn nearest(
    projection: &Projection,
    places: impl Iterator<Item = DVec3>,
    pointer: DVec2,
) -> Option<usize> {
    let mut best = None;
    let mut least = REACH * REACH;
    for (index, place) in places.enumerate() {
        let distance = projection.image(place).distance_squared(pointer);
        if distance < least || (distance == least && best.is_none()) {
            (best, least) = (Some(index), distance);
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::super::projection::tests::viewport;
    use super::*;
    use crate::setup::View;
    use vides_document::Edit;

    fn scene() -> (Document, Projection) {
        let mut document = Document::new();
        for (at, position) in [DVec3::new(0.6, 0.21, 0.8), DVec3::new(0.0, 0.9, 0.0)]
            .into_iter()
            .enumerate()
        {
            let at = at + 2;
            document.apply(Edit::InsertPoint { at, position }).unwrap();
        }
        document.select(0, 0).unwrap();
        (document, Projection::new(&View::default(), viewport()))
    }

    #[test]
    fn in_the_order_of_importance() {
        let (mut document, projection) = scene();
        let shown = Shown::default();
        let tips = tips(&document).unwrap();
        let at = |document: &Document, point: DVec3, with_vup| {
            pick(
                document,
                &projection,
                &shown,
                projection.image(point),
                with_vup,
            )
        };
        assert_eq!(at(&document, tips.up_tip, true), Some(Handle::Vup));
        assert_eq!(at(&document, tips.up_tip, false), None);
        assert_eq!(at(&document, tips.target, true), Some(Handle::Vpn));
        assert_eq!(at(&document, tips.position, true), Some(Handle::Point(0)));
        // Points 1 and 2 lie within reach of each other: the nearer one, but
        // the current one before that.
        let [p1, p2] = [1, 2].map(|i: usize| document.path().points[i].position);
        assert!(projection.image(p1).distance(projection.image(p2)) < REACH);
        assert_eq!(at(&document, p1, true), Some(Handle::Point(1)));
        assert_eq!(at(&document, p2, true), Some(Handle::Point(2)));
        document.select(1, 0).unwrap();
        assert_eq!(at(&document, p2, true), Some(Handle::Point(1)));
        // A target that lies on another point is taken before that.
        let mut orientation = document.path().points[1].orientations[0].clone();
        let target = document.path().points[3].position;
        orientation.target = vides_engine::path::Target::Absolute(target);
        let edit = Edit::SetOrientation {
            point: 1,
            at: 0,
            orientation,
        };
        document.apply(edit).unwrap();
        assert_eq!(at(&document, target, true), Some(Handle::Vpn));
    }

    #[test]
    fn a_point_seen_along_its_arrow_is_taken_itself() {
        let (document, _) = scene();
        let tips = tips(&document).unwrap();
        // From above VUP points at the viewer, from the front VPN away from him.
        for (tilt, tip) in [(90.0, tips.up_tip), (0.0, tips.target)] {
            let view = View {
                rotation: 0.0,
                tilt,
                ..View::default()
            };
            let projection = Projection::new(&view, viewport());
            let image = projection.image(tip);
            assert!(image.distance(projection.image(tips.position)) < 1e-6);
            let found = pick(&document, &projection, &Shown::default(), image, true);
            assert_eq!(found, Some(Handle::Point(0)), "tilt {tilt}");
        }
    }

    #[test]
    fn within_six_pixels() {
        let (document, projection) = scene();
        let shown = Shown::default();
        let image = projection.image(document.path().points[3].position);
        for turn in 0..16 {
            let way = DVec2::from_angle(f64::from(turn));
            let at = |r: f64| pick(&document, &projection, &shown, image + way * r, true);
            assert_eq!(at(5.99), Some(Handle::Point(3)));
            assert_eq!(at(6.01), None);
        }
    }

    #[test]
    fn what_is_hidden_is_left_alone() {
        let (document, projection) = scene();
        let tips = tips(&document).unwrap();
        let mut shown = Shown::default();
        shown.set(Element::Vup, false);
        shown.set(Element::Vpn, false);
        for point in [tips.up_tip, tips.target] {
            let found = pick(
                &document,
                &projection,
                &shown,
                projection.image(point),
                true,
            );
            assert_eq!(found, None);
        }
    }
}

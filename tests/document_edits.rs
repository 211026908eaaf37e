//! Every edit, in any order, with good and bad values: the document stays one
//! that can be saved, and undo and redo restore every bit.

use glam::{DMat4, DQuat, DVec3};
use proptest::prelude::*;
use vides::deform::Deformation;
use vides::document::{At, Document, Edit, Info, ObjectPoint, Selection};
use vides::path::{
    BaseFrames, CameraPath, CurveParameters, Orientation, OrientationMode, Space, SupportPoint,
    Target, Tcb, Up, ZoomMode,
};
use vides::tools::block::Fit;
use vides::tools::check::{FindingKind, Limits};

/// Numbers from which an edit is made, whatever its kind.
#[derive(Debug, Clone)]
struct Raw {
    kind: u8,
    a: usize,
    b: usize,
    flag: bool,
    x: [f64; 6],
}

/// Mostly good values, now and then a hard or a bad one.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        12 => -1.0..1.0_f64,
        2 => 1.0..100.0_f64,
        1 => -1e9..1e9_f64,
        1 => prop::sample::select(vec![
            0.0, -0.0, 1.0, -1.0, 0.6, 0.2, 0.8, 1e9, -1e9, 1e10, 5e-324, -1e-310, 720.5,
            f64::NAN, f64::INFINITY, f64::NEG_INFINITY,
        ]),
    ]
}

const KINDS: u8 = 28;

fn raw() -> impl Strategy<Value = Raw> {
    (
        0..KINDS + 1,
        0..64_usize,
        0..64_usize,
        any::<bool>(),
        prop::array::uniform6(number()),
    )
        .prop_map(|(kind, a, b, flag, x)| Raw {
            kind,
            a,
            b,
            flag,
            x,
        })
}

impl Raw {
    fn vector(&self) -> DVec3 {
        DVec3::new(self.x[0], self.x[1], self.x[2])
    }

    fn tcb(&self) -> Tcb {
        Tcb::new(self.x[3], self.x[4], self.x[5])
    }

    fn target(&self) -> Target {
        if self.flag {
            Target::Absolute(self.vector())
        } else {
            Target::Relative(self.vector())
        }
    }

    fn orientation(&self) -> Orientation {
        let mut speeds = [50.0; 10];
        speeds[self.a % 10] = 1.0 + 40.0 * self.x[4].abs();
        Orientation {
            target: self.target(),
            roll: 300.0 * self.x[3],
            zoom: 1.0 + 50.0 * self.x[4].abs(),
            turning: Tcb::new(self.x[5], 0.0, -0.0),
            speeds,
            hold: (self.b % 3) as u32,
            ..Orientation::default()
        }
    }

    /// The edit, with indices that mostly fit the document.
    fn edit(&self, document: &Document) -> Edit {
        let points = document.path().points.len();
        // One too far is among them.
        let at = self.a % (points + 1);
        let count = document.path().points[at.min(points - 1)]
            .orientations
            .len();
        let orientation = self.b % (count + 1);
        match self.kind {
            0 => Edit::InsertPoint {
                at: self.a % (points + 2),
                position: self.vector(),
            },
            1 => Edit::AppendAfterLast,
            2 => Edit::PrependBeforeFirst,
            3 => Edit::DivideSegment {
                segment: at,
                points: self.b % 12,
            },
            4 => Edit::RemovePoint { at },
            5 => Edit::set(At::Point(at), "position", self.vector()),
            6 => Edit::set(
                At::Point(at),
                "name",
                self.flag.then(|| {
                    ["", "eck\u{e4} \"q\" \\ #", "tab\tis refused", "start"][self.b % 4].to_owned()
                }),
            ),
            7 => Edit::set(At::Point(at), "own", self.tcb()),
            8 => Edit::set(At::Point(at), "preset", self.b % 11),
            9 => Edit::SetPreset {
                preset: self.b % 11,
                tcb: self.tcb(),
            },
            10 => Edit::InsertOrientation {
                point: at,
                at: self.b % (count + 2),
                orientation: self.flag.then(|| self.orientation()),
            },
            11 => Edit::RemoveOrientation {
                point: at,
                at: orientation,
            },
            12 => Edit::SetOrientation {
                point: at,
                at: orientation,
                orientation: self.orientation(),
            },
            13 => Edit::SetAbsolute {
                point: at,
                at: orientation,
                absolute: self.flag,
            },
            14 => Edit::set(
                At::Path,
                "base_speeds",
                BaseFrames {
                    movement: self.x[0].abs(),
                    turning: 100.0,
                    zoom: self.x[1].abs(),
                    rolling: 1.0,
                },
            ),
            15 => Edit::set(At::Path, "closed", self.flag),
            16 => Edit::SetModes(
                [
                    OrientationMode::Tcb,
                    OrientationMode::BarryGoldman,
                    OrientationMode::Slerp,
                ][self.a % 3],
                [ZoomMode::Smooth, ZoomMode::Linear][self.b % 2],
            ),
            17 => Edit::SetInfo(Box::new(self.info())),
            18 => Edit::ReplacePath(Box::new(self.path())),
            19 => Edit::TransformPoints {
                points: vec![at, self.b % points],
                matrix: DMat4::from_scale_rotation_translation(
                    DVec3::splat(1.0 + self.x[3]),
                    DQuat::from_rotation_x(self.x[4]),
                    self.vector(),
                ),
                with_targets: self.flag,
            },
            20 => Edit::DeformPoints {
                points: (0..at).collect(),
                deformation: Deformation::new("twist", &[1.0, 90.0]).unwrap(),
                bounds: None,
                with_targets: self.flag,
            },
            // So that paths do not grow for ever.
            21 if points < 40 => Edit::InsertPath {
                at,
                block: Box::new(self.path()),
                fit: [Fit::None, Fit::Move, Fit::Turn, Fit::Scale][self.b % 4],
                with_targets: self.flag,
            },
            22 => Edit::Reverse,
            23 if points < 12 => Edit::Repeat(self.b % 4),
            24 => Edit::SetSpace {
                space: Space {
                    centre: self.vector(),
                    half_size: self.x[3].abs() * [1.0, 1e-6, 1e6][self.a % 3],
                    up: [Up::Y, Up::Z][self.b % 2],
                },
                fit: self.flag,
            },
            25 => Edit::MovePoint {
                from: at,
                to: (at + 1 + self.b % points) % (points + 1),
            },
            26 => Edit::ChangeUp([Up::Y, Up::Z][self.b % 2]),
            // Copies a target onto a point: an absolute target where the next
            // insertion may lie.
            _ => Edit::InsertPoint {
                at: at.min(points),
                position: match document.path().points[at.min(points - 1)].orientations[0].target {
                    Target::Absolute(target) => target,
                    Target::Relative(_) => self.vector(),
                },
            },
        }
    }

    fn info(&self) -> Info {
        Info {
            title: ["", "a \"title\"", "two\nlines"][self.a % 3].to_owned(),
            comment: [
                "",
                "\"\"\"\n\"\" \\ \r\n\t\u{7f}\u{1}\u{85}\u{1F3A5}\"",
                "one line\"",
            ][self.b % 3]
                .to_owned(),
            fps: self.x[3].abs(),
            first_frame: self.a as i32 - 30,
            unit: "m".to_owned(),
            object: (0..self.b % 5)
                .map(|index| ObjectPoint {
                    position: DVec3::splat(self.x[index]),
                    draw: (self.a >> index).is_multiple_of(2),
                })
                .collect::<Vec<_>>()
                .into(),
            limits: {
                let mut limits = Limits::default();
                let _ = limits.set(FindingKind::Turning, 90.0 * self.x[0]);
                limits
            },
        }
    }

    fn path(&self) -> CameraPath {
        let mut path = CameraPath {
            closed: self.flag,
            ..CameraPath::default()
        };
        for index in 0..self.a % 4 {
            let mut point = SupportPoint::new(DVec3::new(self.x[index], 0.5, 0.25));
            point.name = Some(String::new());
            point.curve = CurveParameters::Own(self.tcb());
            point.orientations.push(self.orientation());
            path.points.push(point);
        }
        path
    }
}

/// Everything that undo restores; `{:?}` tells 0 from −0 and gives every digit.
fn whole(document: &Document) -> String {
    format!("{} {:?}", content(document), document.selection())
}

fn content(document: &Document) -> String {
    format!("{:?} {:?}", document.path(), document.info())
}

fn assert_sound(document: &Document) {
    document.path().check().unwrap();
    document.info().check(document.path().space).unwrap();
    let Selection { point, orientation } = document.selection();
    assert!(orientation < document.path().points[point].orientations.len());
    for point in &document.path().points {
        for orientation in &point.orientations {
            assert!(orientation.roll > -180.0 && orientation.roll <= 180.0);
        }
    }
    let text = document.to_toml().unwrap();
    let loaded = Document::from_toml(&text).unwrap_or_else(|error| panic!("{error} in\n{text}"));
    assert_eq!(content(&loaded), content(document), "{text}");
    assert_eq!(loaded.to_toml().unwrap(), text);
}

/// What is kept up to date edit by edit is what is computed at once.
fn assert_computed(document: &Document) {
    let fresh = Document::from_parts(document.path().clone(), document.info().clone()).unwrap();
    let figures = |document: &Document| {
        document
            .timeline(|timeline| {
                let sections: Vec<_> = (0..timeline.section_count())
                    .map(|index| timeline.section(index))
                    .collect();
                let lengths: Vec<_> = (0..document.path().segment_count())
                    .map(|segment| timeline.segment_length(segment).to_bits())
                    .collect();
                (sections, lengths)
            })
            .unwrap()
    };
    assert_eq!(figures(document), figures(&fresh));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..Default::default() })]

    #[test]
    fn any_edits_can_be_undone_and_done_again(raws in prop::collection::vec(raw(), 1..40)) {
        let mut document = Document::new();
        let mut befores = Vec::new();
        assert_computed(&document);
        for raw in &raws {
            let before = whole(&document);
            if raw.kind == KINDS {
                let _ = document.select(raw.a % 4, raw.b % 2);
                prop_assert_eq!(content(&document), before.split(" Selection").next().unwrap());
                continue;
            }
            let content_before = content(&document);
            if document.apply(raw.edit(&document)).is_err() {
                prop_assert_eq!(whole(&document), before);
                continue;
            }
            assert_sound(&document);
            assert_computed(&document);
            if content(&document) == content_before && !matches!(raw.kind, 17 | 18 | 22 | 23 | 25) {
                prop_assert_eq!(whole(&document), before);
                continue;
            }
            let after = whole(&document);
            prop_assert!(!document.can_redo());
            prop_assert!(document.undo());
            prop_assert_eq!(whole(&document), before.clone());
            assert_computed(&document);
            prop_assert!(document.redo());
            prop_assert_eq!(whole(&document), after);
            assert_computed(&document);
            befores.push(before);
        }
        prop_assert_eq!(document.is_modified(), !befores.is_empty());
        let last = whole(&document);
        let mut afters = vec![last];
        for before in befores.iter().rev() {
            prop_assert!(document.undo());
            prop_assert_eq!(whole(&document), before.clone());
            afters.push(whole(&document));
        }
        prop_assert!(!document.undo());
        prop_assert!(!document.is_modified());
        afters.pop();
        for after in afters.into_iter().rev() {
            prop_assert!(document.redo());
            prop_assert_eq!(whole(&document), after);
        }
        prop_assert!(!document.redo());
    }

    #[test]
    fn a_step_of_many_edits_is_one(
        before in prop::collection::vec(raw(), 0..8),
        within in prop::collection::vec(raw(), 0..30),
    ) {
        let mut document = Document::new();
        for raw in &before {
            let _ = document.apply(raw.edit(&document));
        }
        document.mark_saved();
        let start = whole(&document);
        document.begin_step();
        for raw in &within {
            let _ = document.apply(raw.edit(&document));
        }
        document.cancel_step();
        prop_assert_eq!(whole(&document), start.clone());
        prop_assert!(!document.is_modified());

        document.begin_step();
        let mut changed = false;
        for raw in &within {
            let modified = content(&document);
            let _ = document.apply(raw.edit(&document));
            changed |= content(&document) != modified;
        }
        document.end_step();
        if changed {
            let end = whole(&document);
            prop_assert!(document.undo());
            prop_assert_eq!(whole(&document), start);
            prop_assert!(!document.is_modified());
            prop_assert!(document.redo());
            prop_assert_eq!(whole(&document), end);
            assert_computed(&document);
        }
    }

    #[test]
    fn edits_together_are_done_all_or_none(
        before in prop::collection::vec(raw(), 0..8),
        within in prop::collection::vec(raw(), 0..4),
        together in prop::collection::vec(raw(), 0..6),
        part in any::<bool>(),
    ) {
        let mut document = Document::new();
        for raw in &before {
            let _ = document.apply(raw.edit(&document));
        }
        // Of what there is now: later ones may find no point of theirs.
        let edits: Vec<Edit> = together.iter().map(|raw| raw.edit(&document)).collect();
        let start = whole(&document);
        document.mark_saved();
        if part {
            document.begin_step();
            for raw in &within {
                let _ = document.apply(raw.edit(&document));
            }
        }
        let middle = whole(&document);
        let mut one_by_one = Document::from_parts(
            document.path().clone(), document.info().clone(),
        ).unwrap();
        let at = document.selection();
        one_by_one.select(at.point, at.orientation).unwrap();
        let possible = edits.iter().all(|edit| one_by_one.apply(edit.clone()).is_ok());
        prop_assert_eq!(document.apply_all(edits).is_ok(), possible);
        prop_assert_eq!(document.in_step(), part);
        let end = if possible { whole(&one_by_one) } else { middle };
        prop_assert_eq!(whole(&document), end.clone());
        assert_computed(&document);
        document.end_step();
        if document.is_modified() {
            prop_assert!(document.undo());
            prop_assert_eq!(whole(&document), start);
            prop_assert!(!document.is_modified());
            prop_assert!(document.redo());
            prop_assert_eq!(whole(&document), end);
        } else {
            prop_assert_eq!(whole(&document), start);
        }
    }

    #[test]
    fn without_history_the_same_is_done(raws in prop::collection::vec(raw(), 1..30)) {
        let mut with = Document::new();
        let mut without = Document::new().without_history();
        for raw in &raws {
            let a = with.apply(raw.edit(&with)).map_err(|error| error.to_string());
            let b = without.apply(raw.edit(&without)).map_err(|error| error.to_string());
            prop_assert_eq!(a, b);
            prop_assert_eq!(whole(&with), whole(&without));
            prop_assert_eq!(with.is_modified(), without.is_modified());
        }
        prop_assert!(!without.can_undo());
        prop_assert!(!without.undo());
        let copy = with.try_clone().unwrap();
        prop_assert_eq!(whole(&copy), whole(&with));
        prop_assert_eq!(copy.is_modified(), with.is_modified());
        prop_assert!(!copy.can_undo());
    }
}

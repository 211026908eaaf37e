//! Every edit, in any order, with good and bad values: the document stays one
//! that can be saved, and undo and redo restore every bit.

use glam::{DMat4, DQuat, DVec3};
use proptest::prelude::*;
use vides::deform::Deformation;
use vides::document::{At, Document, Edit, Info, ObjectPoint, Selection, properties};
use vides::error::ErrorKind;
use vides::path::camera_path::DEFAULT_PRESETS;
use vides::path::{
    BaseFrames, CameraPath, CurveParameters, Ease, EaseKind, Orientation, PacePart, PaceSource,
    Space, SupportPoint, Target, Tcb, TurningPart, Up, UpPath,
};
use vides::property::{Kind, Owner, Value};
use vides::scene::{self, Camera, Extrapolation, FollowPath, Keep, Node, Part, Scene};
use vides::tools::block::Fit;
use vides::tools::check::{FindingKind, Limits};

/// Numbers from which an edit is made, whatever its kind.
#[derive(Debug, Clone)]
struct Raw {
    kind: u8,
    a: usize,
    b: usize,
    c: usize,
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

/// How many edits there are, in the order of [`kind`].
const KINDS: u8 = 29;

/// Numbers of what is no edit, and of edits that set a property: there are many.
const SELECT: u8 = KINDS;
const MORE_SETS: u8 = 8;

/// The number by which [`Raw::edit`] makes such an edit; one that is new has none yet.
fn kind(edit: &Edit) -> u8 {
    match edit {
        Edit::InsertPoint { .. } => 0,
        Edit::AppendAfterLast => 1,
        Edit::PrependBeforeFirst => 2,
        Edit::DivideSegment { .. } => 3,
        Edit::RemovePoint { .. } => 4,
        Edit::InsertOnCurve { .. } => 5,
        Edit::FitFrames { .. } => 6,
        Edit::EditNode(_) => 7,
        Edit::ReplaceScene(_) => 8,
        Edit::InsertOrientation { .. } => 9,
        Edit::RemoveOrientation { .. } => 10,
        Edit::SetOrientation { .. } => 11,
        Edit::SetAbsolute { .. } => 12,
        Edit::SetInfo(_) => 13,
        Edit::ReplacePath(_) => 14,
        Edit::TransformPoints { .. } => 15,
        Edit::DeformPoints { .. } => 16,
        Edit::InsertPath { .. } => 17,
        Edit::Reverse => 18,
        Edit::Repeat(_) => 19,
        Edit::SetSpace { .. } => 20,
        Edit::MovePoint { .. } => 21,
        Edit::ChangeUp(_) => 22,
        Edit::Set { .. } => 23,
        Edit::Part(_) => 24,
        Edit::AddNodes(_) => 25,
        Edit::CopyNodes(_) => 26,
        Edit::SetParent { .. } => 27,
        Edit::RenameMarker { .. } => 28,
    }
}

fn raw() -> impl Strategy<Value = Raw> {
    (
        0..KINDS + 1 + MORE_SETS,
        0..64_usize,
        0..64_usize,
        0..4096_usize,
        any::<bool>(),
        prop::array::uniform6(number()),
    )
        .prop_map(|(kind, a, b, c, flag, x)| Raw {
            kind,
            a,
            b,
            c,
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
            5 if points < 40 => Edit::InsertOnCurve {
                frame: 1.0 + 300.0 * self.x[0].abs(),
            },
            6 => Edit::FitFrames {
                first: at,
                last: self.b % points,
                frames: 20 * self.a,
            },
            7 => Edit::EditNode(self.flag.then_some(self.b % 4)),
            24 => Edit::Part(Box::new(self.part())),
            25 => {
                let mut node = Node::new(["a", "b", "c", "d"][self.a % 4], scene::Kind::Group);
                node.parent = self.flag.then_some(self.b % 4);
                Edit::AddNodes(vec![node])
            }
            26 => Edit::CopyNodes(vec![self.a % 4]),
            27 => Edit::SetParent {
                node: self.a % 4,
                parent: self.flag.then_some(self.b % 4),
                keep: if self.c.is_multiple_of(2) {
                    Keep::Place
                } else {
                    Keep::Numbers
                },
            },
            28 => Edit::RenameMarker {
                from: ["m", "n"][self.a % 2].to_owned(),
                to: ["m", "n"][self.b % 2].to_owned(),
            },
            8 => Edit::ReplaceScene(Box::new(self.scene())),
            9 => Edit::InsertOrientation {
                point: at,
                at: self.b % (count + 2),
                orientation: self.flag.then(|| self.orientation()),
            },
            10 => Edit::RemoveOrientation {
                point: at,
                at: orientation,
            },
            11 => Edit::SetOrientation {
                point: at,
                at: orientation,
                orientation: self.orientation(),
            },
            12 => Edit::SetAbsolute {
                point: at,
                at: orientation,
                absolute: self.flag,
            },
            13 => Edit::SetInfo(Box::new(self.info())),
            14 => Edit::ReplacePath(Box::new(self.path())),
            15 => Edit::TransformPoints {
                points: vec![at, self.b % points],
                matrix: DMat4::from_scale_rotation_translation(
                    DVec3::splat(1.0 + self.x[3]),
                    DQuat::from_rotation_x(self.x[4]),
                    self.vector(),
                ),
                with_targets: self.flag,
            },
            16 => Edit::DeformPoints {
                points: (0..at).collect(),
                deformation: Deformation::new("twist", &[1.0, 90.0]).unwrap(),
                bounds: None,
                with_targets: self.flag,
            },
            // So that paths do not grow for ever.
            17 if points < 40 => Edit::InsertPath {
                at,
                block: Box::new(self.path()),
                fit: [Fit::None, Fit::Move, Fit::Turn, Fit::Scale][self.b % 4],
                with_targets: self.flag,
            },
            18 => Edit::Reverse,
            19 if points < 12 => Edit::Repeat(self.b % 4),
            20 => Edit::SetSpace {
                space: Space {
                    centre: self.vector(),
                    half_size: self.x[3].abs() * [1.0, 1e-6, 1e6][self.a % 3],
                    up: [Up::Y, Up::Z][self.b % 2],
                },
                fit: self.flag,
            },
            21 => Edit::MovePoint {
                from: at,
                to: (at + 1 + self.b % points) % (points + 1),
            },
            22 => Edit::ChangeUp([Up::Y, Up::Z][self.b % 2]),
            5 | 17 | 19 => Edit::InsertPoint {
                at: at.min(points),
                position: match document.path().points[at.min(points - 1)].orientations[0].target {
                    // Onto a point: an absolute target where the next insertion may lie.
                    Target::Absolute(target) if self.flag => target,
                    _ => self.vector(),
                },
            },
            _ => {
                let all = properties();
                let row = &all[self.c % all.len()];
                let place = match row.owner {
                    Owner::Path => At::Path,
                    Owner::Point => At::Point(at),
                    Owner::View => At::View(at, orientation),
                };
                let value = match self.c % 61 {
                    0 => Value::Unset,
                    // Of a kind that may be another's.
                    1 => self.value(all[self.b % all.len()].kind),
                    _ => self.value(row.kind),
                };
                Edit::set(place, row.key, value)
            }
        }
    }

    fn value(&self, kind: Kind) -> Value {
        let x = self.x;
        let of_speeds = PaceSource::Speeds {
            speeds: self.orientation().speeds,
            before: self.flag.then_some(1.0 + 50.0 * x[0].abs()),
            after: None,
        };
        let ease = Ease {
            kind: EaseKind::ALL[self.a % 2],
            rise: x[0].abs(),
            fall: 0.5 * x[1].abs(),
            cruise: 1.0 + 50.0 * x[2].abs(),
        };
        match kind {
            Kind::Number => Value::Number(x[0] * [1.0, 60.0][self.a % 2]),
            Kind::Whole => Value::Whole(self.b as i64 - 2),
            Kind::Switch => Value::Switch(self.flag),
            Kind::Choice(names) => Value::Choice(names[self.a % names.len()]),
            Kind::Text => Value::Text(
                ["", "eck\u{e4} \"q\" \\ #", "two\nlines", "start"][self.b % 4].to_owned(),
            ),
            Kind::Place => Value::Place(self.vector()),
            Kind::Vector => Value::Vector(self.vector()),
            Kind::Pair(names) => Value::Pair(names, [self.vector(), DVec3::splat(x[3])]),
            Kind::Speeds => Value::Speeds(self.orientation().speeds),
            Kind::Shape => Value::Shape(self.tcb()),
            Kind::Presets => {
                let mut presets = DEFAULT_PRESETS;
                presets[self.a % 10] = self.tcb();
                Value::Presets(presets)
            }
            Kind::BaseFrames => Value::BaseFrames(BaseFrames {
                movement: 100.0 * x[0].abs(),
                turning: 100.0,
                zoom: 100.0 * x[1].abs(),
                rolling: 1.0,
            }),
            Kind::Ease => Value::Ease(ease),
            Kind::Distance => Value::Distance([[0.0, 0.0], [x[0].abs(), 0.5], [1.0, 1.0]].into()),
            Kind::Part => Value::Part(PacePart {
                of: of_speeds,
                from: 0.25 * x[3].abs(),
                to: 0.5 + 0.5 * x[4].abs(),
            }),
            Kind::Turning => Value::Turning(TurningPart {
                control: [x[0], x[1], x[2], 0.0].map(DQuat::from_rotation_x),
                from: 0.0,
                to: x[3].abs(),
            }),
            Kind::UpPath => match self.path() {
                path if path.check().is_ok() => Value::UpPath(UpPath::of(&path).unwrap()),
                _ => Value::Unset,
            },
            Kind::Nested => Value::Unset,
        }
    }

    /// Cameras and lamps, with paths and without.
    fn scene(&self) -> Scene {
        let mut scene = Scene::new();
        for at in 0..self.a % 4 {
            let kind = [scene::Kind::Group, scene::Kind::Camera(Camera::default())][at % 2].clone();
            let mut node = Node::new(&format!("node {at}"), kind);
            if !(self.b + at).is_multiple_of(3) {
                // As the document would have it, rolls and names included.
                if let Ok(document) = Document::from_parts(self.path(), Info::default()) {
                    let (path, start) = (document.into_parts().0, 1.0 + self.b as f64);
                    let path = FollowPath::new(path, start, Extrapolation::Hold);
                    let _ = path.and_then(|path| node.set_path(Some(path)));
                }
            }
            let _ = scene.add(node);
        }
        scene
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

    fn part(&self) -> Part {
        let node = self.a % 4;
        match self.c % 6 {
            0 => Part::Remove(vec![node]),
            1 => Part::Marker {
                name: ["m", "n"][self.b % 2].to_owned(),
                frame: self.flag.then_some(self.x[0] * 100.0),
            },
            2 => Part::Pin {
                node,
                point: self.b % 4,
                marker: self.flag.then(|| "m".to_owned()),
            },
            3 => Part::Camera(self.flag.then_some(node)),
            4 => Part::path(node, None).unwrap(),
            _ => Part::Range(self.flag.then_some((self.x[0], self.x[1] * 100.0))),
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
    let scene = document.edited_scene().map(|edited| {
        let scene = edited.scene();
        let nodes = scene.nodes().iter().map(|node| {
            let path = node.path().map(|follow| format!("{:?}", follow.path()));
            (node.name.clone(), node.parent, node.rest, path)
        });
        let nodes: Vec<_> = nodes.collect();
        let shown = (scene.camera(), scene.range(), scene.markers(), scene.pins());
        format!(
            "{:?} {:?} {nodes:?} {shown:?}",
            edited.node(),
            scene.space()
        )
    });
    format!("{:?} {:?} {scene:?}", document.path(), document.info())
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
    let text = match document.to_toml() {
        Ok(text) => text,
        // Where a node of a scene is too late, its path can have too many frames for it.
        Err(error) => {
            assert!(document.edited_scene().is_some(), "{error}");
            assert_eq!(error.kind(), ErrorKind::Limit);
            return;
        }
    };
    if document.edited_scene().is_some() {
        let loaded = Document::scene_from_toml(&text, "".as_ref());
        let (loaded, _) = loaded.unwrap_or_else(|error| panic!("{error} in\n{text}"));
        assert_eq!(loaded.to_toml().unwrap(), text);
        return;
    }
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

#[test]
fn no_edit_is_missing() {
    let mut document = Document::new();
    document.apply(Edit::AppendAfterLast).unwrap();
    for number in 0..KINDS {
        let (a, b, c, flag, x) = (1, 2, 3, true, [0.5; 6]);
        let raw = Raw {
            kind: number,
            a,
            b,
            c,
            flag,
            x,
        };
        assert_eq!(kind(&raw.edit(&document)), number);
    }
}

/// The node whose path is edited.
fn node(document: &Document) -> Option<Option<usize>> {
    document.edited_scene().map(|edited| edited.node())
}

/// Lets a node that was chosen go into a step.
fn settle(document: &mut Document) {
    let title = "settled".to_owned();
    let info = Info {
        title,
        ..document.info().clone()
    };
    document.apply(Edit::SetInfo(Box::new(info))).unwrap();
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..Default::default() })]

    #[test]
    fn any_edits_can_be_undone_and_done_again(raws in prop::collection::vec(raw(), 1..40)) {
        let mut document = Document::new();
        let (mut befores, mut modified) = (Vec::new(), false);
        // What was there before another node was chosen.
        let mut away = None;
        assert_computed(&document);
        for raw in &raws {
            let before = whole(&document);
            if raw.kind == SELECT {
                let _ = document.select(raw.a % 4, raw.b % 2);
                prop_assert_eq!(content(&document), before.split(" Selection").next().unwrap());
                continue;
            }
            let content_before = content(&document);
            let edit = raw.edit(&document);
            let of = kind(&edit);
            if document.apply(edit).is_err() {
                prop_assert_eq!(whole(&document), before);
                continue;
            }
            assert_sound(&document);
            assert_computed(&document);
            if content(&document) == content_before && !matches!(of, 8 | 13 | 14 | 18 | 19 | 21) {
                prop_assert_eq!(whole(&document), before);
                continue;
            }
            // To choose a node is no step; it goes back with the next one.
            if of == 7 {
                away.get_or_insert(before);
                continue;
            }
            let before = away.take().unwrap_or(before);
            let after = whole(&document);
            prop_assert!(!document.can_redo());
            prop_assert!(document.undo());
            prop_assert_eq!(whole(&document), before.clone());
            assert_computed(&document);
            prop_assert!(document.redo());
            prop_assert_eq!(whole(&document), after);
            assert_computed(&document);
            befores.push(before);
            modified = true;
        }
        prop_assert_eq!(document.is_modified(), modified);
        let last = away.unwrap_or_else(|| whole(&document));
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
        settle(&mut document);
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
        settle(&mut document);
        // Of what there is now: later ones may find no point of theirs.
        let edits: Vec<Edit> = together.iter().map(|raw| raw.edit(&document)).collect();
        let (start, first) = (whole(&document), node(&document));
        document.mark_saved();
        if part {
            document.begin_step();
            for raw in &within {
                let _ = document.apply(raw.edit(&document));
            }
        }
        let middle = whole(&document);
        let mut one_by_one = document.try_clone().unwrap();
        let possible = edits.iter().all(|edit| one_by_one.apply(edit.clone()).is_ok());
        prop_assert_eq!(document.apply_all(edits).is_ok(), possible);
        prop_assert_eq!(document.in_step(), part);
        let end = if possible { whole(&one_by_one) } else { middle };
        prop_assert_eq!(whole(&document), end.clone());
        assert_computed(&document);
        document.end_step();
        // Another node to edit is a step, but not one that a file would show.
        if document.is_modified() || node(&document) != first {
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

#[test]
fn no_node_is_edited_in_whose_space_the_object_would_be_too_far_away() {
    let mut scene = Scene::new();
    for (name, half_size) in [("far", 1e6), ("near", 1.0)] {
        let mut path = CameraPath::default();
        path.space.half_size = half_size;
        let mut node = Node::new(name, scene::Kind::Group);
        let path = FollowPath::new(path, 1.0, Extrapolation::Hold).unwrap();
        node.set_path(Some(path)).unwrap();
        scene.add(node).unwrap();
    }
    let mut document = Document::new();
    document.apply(Edit::ReplaceScene(Box::new(scene))).unwrap();
    let _ = document.apply(Edit::EditNode(Some(0)));
    let mut info = Info::default();
    let position = DVec3::splat(1e14);
    info.object = vec![ObjectPoint {
        position,
        draw: true,
    }]
    .into();
    document.apply(Edit::SetInfo(Box::new(info))).unwrap();
    let before = whole(&document);
    let error = document.apply(Edit::EditNode(Some(1))).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Range);
    assert_eq!(whole(&document), before);
}

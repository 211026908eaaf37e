//! Edits made of numbers, whatever their kind: what proptest draws and makes smaller.

use glam::{DMat4, DQuat, DVec3};
use proptest::prelude::*;
use vides::deform::Deformation;
use vides::document::{At, Document, Edit, Info, ObjectPoint, properties};
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
pub(super) struct Raw {
    pub(super) kind: u8,
    pub(super) a: usize,
    pub(super) b: usize,
    pub(super) c: usize,
    pub(super) flag: bool,
    pub(super) x: [f64; 6],
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

macro_rules! kinds {
    ($($edit:ident)*) => {
        #[repr(u8)]
        enum Number { $($edit),* }

        /// How many edits there are.
        pub(super) const KINDS: u8 = [$(Number::$edit as u8),*].len() as u8;

        /// The number by which [`Raw::edit`] makes such an edit; one that is new has none yet.
        pub(super) fn kind(edit: &Edit) -> u8 {
            match edit {
                $(Edit::$edit { .. } => Number::$edit as u8,)*
            }
        }
    };
}

kinds! {
    InsertPoint
    AppendAfterLast
    PrependBeforeFirst
    DivideSegment
    RemovePoint
    InsertOnCurve
    FitFrames
    EditNode
    ReplaceScene
    InsertOrientation
    RemoveOrientation
    SetOrientation
    SetAbsolute
    SetInfo
    ReplacePath
    TransformPoints
    DeformPoints
    InsertPath
    Reverse
    Repeat
    SetSpace
    MovePoint
    ChangeUp
    Set
    Part
    AddNodes
    CopyNodes
    SetParent
    RenameMarker
}

/// Numbers of what is no edit, and of edits that set a property: there are many.
pub(super) const SELECT: u8 = KINDS;

const MORE_SETS: u8 = 8;

pub(super) fn raw() -> impl Strategy<Value = Raw> {
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
    #[expect(clippy::too_many_lines)] // told in one piece
    pub(super) fn edit(&self, document: &Document) -> Edit {
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
                    Owner::Node => At::Node(at),
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
            slopes: [50.0 * x[0], 0.0],
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
            Kind::Rotation => Value::Rotation(DQuat::from_xyzw(x[0], x[1], x[2], x[3])),
            Kind::Colour => Value::Colour([x[0], x[1], x[2]].map(f64::abs)),
            Kind::Cone => Value::Cone([10.0 * x[0].abs(), 30.0]),
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

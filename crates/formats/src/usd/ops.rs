//! The operations that place a prim (UsdGeomXformable): ours are kept as they are, others become
//! position, rotation and scale.

use glam::{DAffine3, DMat4, DQuat, DVec3};

use super::curve::{Curve, all_times, quaternion};
use super::lexer::Lexer;
use super::stage::{Prim, Stage};
use crate::convention;
use crate::error::{Cause, Result, Wanted};
use vides_document::error::vec_with_room;
use vides_engine::math::euler::of_euler;

/// Operations of one prim.
const MAX_OPS: usize = 64;

/// What an operation does.
#[derive(Debug, Clone, PartialEq)]
enum Kind {
    Translate,
    Scale,
    /// Turns about axes by degrees, the first axis first.
    Rotate(Vec<usize>),
    Orient,
    Matrix,
}

#[derive(Debug)]
struct Op {
    kind: Kind,
    name: String,
    inverted: bool,
    /// Of as many numbers as the kind has; those along one axis have three.
    curve: Curve,
}

/// How a prim lies in the one it is in.
#[derive(Debug, Default)]
pub(super) struct Placed {
    pub(super) position: Option<Curve>,
    pub(super) pivot: DVec3,
    /// Quaternions w x y z of length 1, or yaw, pitch and roll in degrees.
    pub(super) rotation: Option<Curve>,
    pub(super) scale: Option<Curve>,
    /// Whether it lies in the world, whatever it is in.
    pub(super) in_world: bool,
    /// Whether keys were recomputed, so that the motion between them differs.
    pub(super) sampled: bool,
    /// Whether it shears, which is left out.
    pub(super) sheared: bool,
}

/// How many keys may be computed between those of a file.
pub(super) struct Room(pub(super) usize);

impl Op {
    fn matrix(&self, time: f64) -> DAffine3 {
        let matrix = match &self.kind {
            Kind::Translate => DAffine3::from_translation(self.curve.at::<3>(time).into()),
            Kind::Scale => DAffine3::from_scale(self.curve.at::<3>(time).into()),
            Kind::Orient => DAffine3::from_quat(self.curve.rotation(time)),
            Kind::Rotate(axes) => DAffine3::from_quat(turn(axes, self.curve.at(time))),
            Kind::Matrix => {
                // Its rows are our columns.
                let matrix = DMat4::from_cols_array(&self.curve.at::<16>(time));
                DAffine3::from_mat4(matrix)
            }
        };
        if self.inverted {
            matrix.inverse()
        } else {
            matrix
        }
    }

    /// Whether the engine has a track for the rotation, with the same values between its keys.
    fn has_track(&self) -> bool {
        match &self.kind {
            Kind::Orient => true,
            // Roll, then pitch, then yaw; a turn about one axis is one of them.
            Kind::Rotate(axes) => axes.len() == 1 || axes[..] == [2, 0, 1],
            _ => false,
        }
    }
}

/// Degrees about axes, x y z, the first axis first.
fn turn(axes: &[usize], degrees: [f64; 3]) -> DQuat {
    of_euler(degrees.map(f64::to_radians), axes)
}

impl<'a> Stage<'a> {
    fn ops(&self, prim: &Prim<'a>) -> Result<(bool, Vec<Op>)> {
        let (place, names) = self.texts(prim, "xformOpOrder", MAX_OPS)?;
        let (mut ops, mut in_world) = (Vec::new(), false);
        for name in names {
            if name == "!resetXformStack!" {
                (in_world, ops) = (true, Vec::new());
                continue;
            }
            let plain = name.strip_prefix("!invert!");
            let inverted = plain.is_some();
            let name = plain.unwrap_or(&name).to_owned();
            if let Some(op) = self.op(prim, &place, name, inverted)? {
                ops.push(op);
            }
        }
        Ok((in_world, ops))
    }

    /// An operation; none if it has no value, and so does nothing.
    fn op(
        &self,
        prim: &Prim<'a>,
        place: &Lexer<'a>,
        name: String,
        inverted: bool,
    ) -> Result<Option<Op>> {
        let unknown = || place.wrong(Cause::Missing(name.as_str().into()));
        let kind = name.strip_prefix("xformOp:").ok_or_else(unknown)?;
        let kind = kind.split(':').next().unwrap_or("");
        let axis = |sign: char| "XYZ".find(sign);
        let rest = |prefix: &str| kind.strip_prefix(prefix);
        let axes =
            |prefix: &str| -> Option<Vec<usize>> { rest(prefix)?.chars().map(axis).collect() };
        let (kind, width) = match kind {
            "translate" => (Kind::Translate, 3),
            "scale" => (Kind::Scale, 3),
            "orient" => (Kind::Orient, 4),
            "transform" => (Kind::Matrix, 16),
            _ => match (axes("translate"), axes("scale"), axes("rotate")) {
                (Some(axes), ..) if axes.len() == 1 => (Kind::Translate, 1),
                (_, Some(axes), _) if axes.len() == 1 => (Kind::Scale, 1),
                (.., Some(axes)) if axes.len() == 1 || permutes(&axes) => {
                    let width = axes.len();
                    (Kind::Rotate(axes), width)
                }
                _ => return Err(unknown()),
            },
        };
        let Some(mut curve) = self.curve(prim, &name, width)? else {
            return Ok(None);
        };
        if width == 1 {
            let last = name.split(':').nth(1).and_then(|name| name.chars().last());
            let axis = last.and_then(axis).ok_or_else(unknown)?;
            let rest = f64::from(u8::from(kind == Kind::Scale));
            let mut wide = vec_with_room(3 * curve.values.len())?;
            for &value in &curve.values {
                let mut all = [rest; 3];
                all[axis] = value;
                wide.extend(all);
            }
            (curve.values, curve.width) = (wide, 3);
        }
        if kind == Kind::Orient {
            for turn in curve.values.chunks_exact_mut(4) {
                let length = quaternion(turn).length();
                if !(length > 1e-12 && length.is_finite()) {
                    return Err(place.wrong(Cause::NoRotation));
                }
                turn.iter_mut().for_each(|number| *number /= length);
            }
        }
        Ok(Some(Op {
            kind,
            name,
            inverted,
            curve,
        }))
    }

    /// How a prim lies; of a camera or light (`looks`) the rotation is that of quaternions, and there
    /// is no pivot.
    ///
    /// # Errors
    /// What is wrong with an operation; [`Cause::Long`] for too many computed keys.
    pub(super) fn placed(&self, prim: &Prim<'a>, looks: bool, room: &mut Room) -> Result<Placed> {
        let (in_world, ops) = self.ops(prim)?;
        if let Some(placed) = plain(&ops, looks) {
            return Ok(Placed { in_world, ..placed });
        }
        let mut times = all_times(ops.iter().map(|op| &op.curve))?;
        if let (Some(&first), Some(&last)) = (times.first(), times.last()) {
            let whole = (last.floor() - first.ceil()).max(0.0);
            let between = (whole as usize).saturating_add(1);
            room.0 = room
                .0
                .checked_sub(between)
                .ok_or_else(|| self.lexer.line(prim.at).wrong(Cause::Long))?;
            times.try_reserve(between)?;
            times.extend(
                (0..between)
                    .map(|at| first.ceil() + at as f64)
                    .filter(|at| *at <= last),
            );
            times.sort_unstable_by(f64::total_cmp);
            times.dedup();
        }
        let rests = times.is_empty();
        if rests {
            times.push(0.0);
        }
        let numbers = |width: usize| vec_with_room::<f64>(width * times.len());
        let (mut places, mut turns, mut scales) = (numbers(3)?, numbers(4)?, numbers(3)?);
        let mut sheared = false;
        for &time in &times {
            let all = ops.iter().map(|op| op.matrix(time));
            let matrix: DAffine3 = all.fold(DAffine3::IDENTITY, |all, next| all * next);
            if !matrix.is_finite() {
                return Err(self.lexer.line(prim.at).expected(Wanted::Matrix));
            }
            let parts = convention::parts(matrix);
            sheared |= parts.sheared;
            places.extend(parts.position.to_array());
            let turn = parts.rotation;
            turns.extend([turn.w, turn.x, turn.y, turn.z]);
            scales.extend(parts.scale.to_array());
        }
        let same = scales.chunks_exact(3).all(|scale| {
            let mut pairs = scale.iter().zip(&scales[..3]);
            pairs.all(|(a, b)| (a - b).abs() <= 1e-12 * b.abs())
        });
        if same {
            scales.truncate(3);
        }
        let curve = |values: Vec<f64>, width: usize| {
            let all = !rests && values.len() == width * times.len();
            Some(Curve {
                times: if all { times.clone() } else { Vec::new() },
                values,
                width,
            })
        };
        Ok(Placed {
            position: curve(places, 3),
            rotation: curve(turns, 4),
            scale: curve(scales, 3),
            in_world,
            sampled: !rests,
            sheared,
            ..Placed::default()
        })
    }
}

fn permutes(axes: &[usize]) -> bool {
    axes.len() == 3 && (0..3).all(|axis| axes.contains(&axis))
}

/// The operations as they are, if they are ours: translate, pivot, one rotation, scale, pivot back.
fn plain(ops: &[Op], looks: bool) -> Option<Placed> {
    let mut placed = Placed::default();
    let mut rest = ops;
    if let [first, others @ .., last] = rest
        && is_pivot(first, last)
    {
        // Without a translation of its own.
        (placed.pivot, rest) = (first.curve.at::<3>(0.0).into(), others);
    } else {
        if let [first, others @ ..] = rest
            && first.kind == Kind::Translate
            && !first.inverted
        {
            (placed.position, rest) = (Some(first.curve.clone()), others);
        }
        if let [first, others @ .., last] = rest
            && is_pivot(first, last)
        {
            (placed.pivot, rest) = (first.curve.at::<3>(0.0).into(), others);
        }
    }
    if let [first, others @ ..] = rest
        && matches!(first.kind, Kind::Orient | Kind::Rotate(_))
        && !first.inverted
    {
        let rests = first.curve.rests();
        if !rests && !(first.has_track() && (!looks || first.kind == Kind::Orient)) {
            return None;
        }
        placed.rotation = Some(match &first.kind {
            Kind::Rotate(axes) if rests => {
                let turn = turn(axes, first.curve.at(0.0));
                Curve::constant(&[turn.w, turn.x, turn.y, turn.z])
            }
            Kind::Rotate(_) => {
                let mut curve = first.curve.clone();
                // Yaw about y, pitch about x, roll about z.
                curve.map(|degrees| degrees.swap(0, 1));
                curve
            }
            _ => first.curve.clone(),
        });
        rest = others;
    }
    if let [first, others @ ..] = rest
        && first.kind == Kind::Scale
        && !first.inverted
    {
        (placed.scale, rest) = (Some(first.curve.clone()), others);
    }
    (rest.is_empty() && !(looks && placed.pivot != DVec3::ZERO)).then_some(placed)
}

/// Whether the last operation takes back the first one, which rests.
fn is_pivot(first: &Op, last: &Op) -> bool {
    first.kind == Kind::Translate
        && !first.inverted
        && first.curve.rests()
        && last.inverted
        && last.name == first.name
}

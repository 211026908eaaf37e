//! Nodes side by side: where they are is computed a vector of nodes at a time.
//!
//! What a track has around a frame, two keys and the share of the way between, is put into rows, a
//! column for each node; all else that moves a node gives one value, and stands there as both keys.
//! Vectors then go through the rows without a branch, whatever moves the nodes, and no column
//! depends on the others. A group is gathered as a whole before its first vector is computed, since
//! reading at once what was written number by number makes the processor wait.

use std::ops::{Deref, DerefMut};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, OnceLock};

use glam::{DMat4, DVec3};

use super::channel::Channel;
use super::node::{Node, Values};
use super::rotation::{GreatArc, arc_weights};
use super::state::{Looks, NodeState, Warnings};
use super::track::{Interpolation, Track};
use crate::error::{Result, vec_with_room};
use crate::math::vector::{self, Vector, each};
use crate::path::dispatch::widest;
use crate::shared_list::SharedList;

/// Nodes of a group.
pub(super) const GROUP: usize = 16;

/// A number of each node of a group.
type Row = [f64; GROUP];

/// What tracks have at a key and towards the next: position, scale, rotation; then the rotation to
/// which the arc leads, the square and the inverse of that arc.
type Section = [Row; 16];
const SCALE: usize = 3;
const TURN: usize = 6;
const SQUARE: usize = 14;

/// Position, scale, rotation.
const MOTIONS: [Channel; 3] = [Channel::Position, Channel::Scale, Channel::Rotation];

/// Which nodes a group has, their pivots and the shares of the ways of their [`MOTIONS`].
#[derive(Debug, Default)]
struct Head {
    nodes: [usize; GROUP],
    parents: [Option<usize>; GROUP],
    count: usize,
    pivot: [Row; 3],
    shares: Shares,
}

/// The three axes and the place of each node, in its parent.
type Own = [[Row; 3]; 4];

/// Nodes that come one after the other in the order of evaluation, gathered for one frame.
#[derive(Default)]
pub(super) struct Group {
    head: Head,
    /// Both keys.
    keys: [Section; 2],
    own: Own,
    /// The section of the track before ([`Track::straight`]).
    hint: usize,
}

fn put(section: &mut Section, row: usize, lane: usize, numbers: &[f64]) {
    for (row, number) in section[row..].iter_mut().zip(numbers) {
        row[lane] = *number;
    }
}

impl Group {
    /// Adds a node of which tracks alone move the place, and gives its other values.
    pub(super) fn add(
        &mut self,
        at: usize,
        node: &Node,
        frame: f64,
        warnings: &mut Warnings,
    ) -> Values {
        let mut values = node.rest;
        self.put(at, node, &values);
        for track in node.keys.tracks() {
            let Some(motion) = MOTIONS.iter().position(|motion| motion == track.channel()) else {
                track.other(frame, &mut values, warnings);
                continue;
            };
            let found = track.straight(frame, &mut self.hint);
            if found.is_none_or(|found| !self.between(motion, track, found)) {
                match motion {
                    2 => self.along(&GreatArc::still(track.rotation(frame, warnings))),
                    _ => self.still(motion, track.value(frame, warnings).into()),
                }
            }
        }
        values
    }

    /// Adds a node that is where its values say.
    pub(super) fn put(&mut self, at: usize, node: &Node, values: &Values) {
        let head = &mut self.head;
        let lane = head.count;
        head.count += 1;
        (head.nodes[lane], head.parents[lane]) = (at, node.parent);
        for (row, pivot) in head.pivot.iter_mut().zip(node.pivot.to_array()) {
            row[lane] = pivot;
        }
        self.still(0, values.position);
        self.still(1, values.scale);
        self.along(&GreatArc::still(values.rotation));
    }

    fn still(&mut self, motion: usize, value: DVec3) {
        let lane = self.head.count - 1;
        for key in &mut self.keys {
            put(key, SCALE * motion, lane, &value.to_array());
        }
        self.head.shares[motion][lane] = 0.0;
    }

    fn along(&mut self, arc: &GreatArc) {
        let lane = self.head.count - 1;
        put(&mut self.keys[0], TURN, lane, &arc.from.to_array());
        put(&mut self.keys[0], TURN + 4, lane, &arc.to.to_array());
        put(&mut self.keys[0], SQUARE, lane, &[arc.square, arc.inverse]);
        self.head.shares[2][lane] = 0.0;
    }

    /// The node added last on its way within a section of a track; false where that is no arc.
    fn between(&mut self, motion: usize, track: &Track, (section, share): (usize, f64)) -> bool {
        let lane = self.head.count - 1;
        if motion < 2 {
            let keys = &track.values()[3 * section..];
            let next = keys.get(3..6).unwrap_or(&keys[..3]);
            put(&mut self.keys[0], SCALE * motion, lane, &keys[..3]);
            put(&mut self.keys[1], SCALE * motion, lane, next);
        } else if share != 0.0
            && let Some(arc) = track.arc(section)
        {
            self.along(&arc);
        } else {
            return false;
        }
        self.head.shares[motion][lane] = share;
        true
    }

    /// Writes where its nodes are in the world and whether they are seen; it is empty then.
    pub(super) fn place(&mut self, states: &mut [NodeState], warnings: &mut Warnings) {
        let (head, keys) = (&self.head, self.keys.each_ref());
        place_widest(head, keys, &head.shares, &mut self.own, states, warnings);
        self.head.count = 0;
    }
}

/// The shares of the ways of a group's [`MOTIONS`].
type Shares = [Row; 3];

/// The numbers of a vector of nodes.
#[inline(always)]
fn at<V: Vector>(row: &Row, k: usize) -> V {
    V::load(&row[k..])
}

/// L = T(position)·T(pivot)·R·S·T(−pivot) of a vector of nodes, column by column.
#[inline(always)]
fn local<V: Vector>(
    head: &Head,
    [from, to]: [&Section; 2],
    shares: &Shares,
    k: usize,
    own: &mut Own,
) {
    let one = V::splat(1.0);
    let [position, scale] = each!(motion in [0, 1] => {
        let share = at::<V>(&shares[motion], k);
        let rest = one.sub(share);
        each!(row in [SCALE * motion, SCALE * motion + 1, SCALE * motion + 2] => {
            at::<V>(&from[row], k).mul_add(rest, at::<V>(&to[row], k).mul(share))
        })
    });
    let (mut square, mut inverse) = (at(&from[SQUARE], k), at(&from[SQUARE + 1], k));
    if shares[2] == [0.0; GROUP] {
        // The weight of the key is 1 then, and not what comes near it.
        (square, inverse) = (V::splat(0.0), one);
    }
    let [a, b] = arc_weights(square, inverse, at(&shares[2], k));
    let [x, y, z, w] = each!(row in [TURN, TURN + 1, TURN + 2, TURN + 3] => {
        at::<V>(&from[row], k).mul_add(a, at::<V>(&from[row + 4], k).mul(b))
    });
    let square = x.mul_add(x, y.mul_add(y, z.mul_add(z, w.mul(w))));
    let twice = V::splat(2.0).div(square);
    let [tx, ty, tz] = [x.mul(twice), y.mul(twice), z.mul(twice)];
    let (xx, yy, zz) = (x.mul(tx), y.mul(ty), z.mul(tz));
    let (xy, xz, yz) = (x.mul(ty), x.mul(tz), y.mul(tz));
    let (wx, wy, wz) = (w.mul(tx), w.mul(ty), w.mul(tz));
    let axes = [
        [one.sub(yy).sub(zz), xy.add(wz), xz.sub(wy)],
        [xy.sub(wz), one.sub(xx).sub(zz), yz.add(wx)],
        [xz.add(wy), yz.sub(wx), one.sub(xx).sub(yy)],
    ];
    let pivot: [V; 3] = each!(i in [0, 1, 2] => at(&head.pivot[i], k));
    let mut place = each!(i in [0, 1, 2] => position[i].add(pivot[i]));
    for j in 0..3 {
        let along = V::splat(0.0).sub(pivot[j]);
        for i in 0..3 {
            let value = axes[j][i].mul(scale[j]);
            value.store(&mut own[j][i][k..]);
            place[i] = value.mul_add(along, place[i]);
        }
    }
    for i in 0..3 {
        place[i].store(&mut own[3][i][k..]);
    }
}

/// The world matrix of a node, from its local one and that of its parent.
#[inline(always)]
fn world<V: Vector>(own: &Own, lane: usize, parent: &[f64; 16]) -> [f64; 16] {
    let mut matrix = [0.0; 16];
    for i in (0..4).step_by(V::LANES) {
        let axis = each!(j in [0, 1, 2, 3] => V::load(&parent[4 * j + i..]));
        for j in 0..4 {
            let [x, y, z] = each!(k in [0, 1, 2] => V::splat(own[j][k][lane]));
            let mut sum = axis[1].mul_add(y, axis[2].mul(z));
            if j == 3 {
                sum = sum.add(axis[3]);
            }
            axis[0].mul_add(x, sum).store(&mut matrix[4 * j + i..]);
        }
    }
    matrix
}

const IDENTITY: [f64; 16] = DMat4::IDENTITY.to_cols_array();

#[inline(always)]
fn place<V: Vector>(
    head: &Head,
    keys: [&Section; 2],
    shares: &Shares,
    own: &mut Own,
    states: &mut [NodeState],
    warnings: &mut Warnings,
) {
    for k in (0..head.count).step_by(V::LANES) {
        local::<V>(head, keys, shares, k, own);
    }
    for lane in 0..head.count {
        let at = head.nodes[lane];
        let (parent, mut seen) = match head.parents[lane] {
            Some(parent) => (&states[parent].matrix, states[parent].visible != 0),
            None => (&IDENTITY, true),
        };
        let mut matrix = world::<V>(own, lane, parent);
        // 0 unless one of them is not finite: one branch for all.
        let mut sum = V::splat(0.0);
        for i in (0..16).step_by(V::LANES) {
            sum = V::load(&matrix[i..]).mul_add(V::splat(0.0), sum);
        }
        let mut sums = [0.0; 4];
        sum.store(&mut sums);
        if sums.iter().sum::<f64>() != 0.0 {
            // Too far in the world to compute with.
            (matrix, seen) = (IDENTITY, false);
            warnings.too_far(at);
        }
        states[at].matrix = matrix;
        states[at].visible &= i32::from(seen);
    }
}

widest! {
    fn place_widest = self::place;
    (head: &Head, keys: [&Section; 2], shares: &Shares, own: &mut Own, states: &mut [NodeState], warnings: &mut Warnings) -> ()
}

/// A group whose tracks are linear and have their keys at the same frames, as recordings have: all
/// keys are there in rows, so that a frame reads what it needs in one piece and gathers nothing.
/// The numbers come out bit for bit as of a [`Group`]: this may be there or not.
#[derive(Debug)]
pub(super) struct Pack {
    /// Its shares are 1 where a track moves it, else 0.
    head: Head,
    sections: Vec<Section>,
    /// A node and the channel of its track, if there is one: all others are as it is in time.
    clock: Option<(usize, Channel)>,
    looks: [Looks; GROUP],
}

impl Pack {
    /// A pack for each [`GROUP`] in this order that can have one, to be asked for so many `frames`.
    pub(super) fn all(
        nodes: &SharedList<Node>,
        order: &[usize],
        frames: usize,
    ) -> Result<Vec<Option<Self>>> {
        let mut packs = vec_with_room(order.len().div_ceil(GROUP))?;
        for group in order.chunks(GROUP) {
            packs.push(Self::new(nodes, group, frames)?);
        }
        Ok(packs)
    }

    /// Nodes that come one after the other; none if they are not that simple.
    fn new(nodes: &SharedList<Node>, group: &[usize], frames: usize) -> Result<Option<Self>> {
        let mut clock: Option<(usize, &Track)> = None;
        for &at in group {
            let node = &nodes[at];
            if node.kind.looks() || node.path.is_some() {
                return Ok(None);
            }
            for track in node.keys.tracks() {
                let other = clock.get_or_insert((at, track)).1;
                let simple = MOTIONS.contains(track.channel())
                    && *track.interpolation() == Interpolation::Linear
                    && track.frames() == other.frames()
                    && track.extrapolation() == other.extrapolation();
                if !simple {
                    return Ok(None);
                }
            }
        }
        let count = clock.map_or(1, |(_, track)| track.frames().len());
        let numbers: usize = group.iter().map(|&at| nodes[at].keys.numbers()).sum();
        // Rows of nodes that do not move are not to take many times the room of the keys, nor more
        // than what is asked for.
        if 4 * GROUP * (count - 1) > numbers.max(8 * frames) {
            return Ok(None);
        }
        let (mut gathered, mut looks) = (Group::default(), [Looks::default(); GROUP]);
        let mut sections = vec_with_room(count)?;
        for key in 0..count {
            gathered.head.count = 0;
            for (&at, looks) in group.iter().zip(&mut looks) {
                let node = &nodes[at];
                gathered.put(at, node, &node.rest);
                for track in node.keys.tracks() {
                    let motion = MOTIONS.iter().position(|motion| motion == track.channel());
                    gathered.between(motion.unwrap_or(0), track, (key, 1.0));
                }
                *looks = node.rest.looks();
            }
            sections.push(gathered.keys[0]);
        }
        Ok(Some(Self {
            head: gathered.head,
            sections,
            clock: clock.map(|(at, track)| (at, track.channel().clone())),
            looks,
        }))
    }

    /// As [`Group::place`]; false, and nothing written, where the tracks go on with an offset.
    pub(super) fn place(
        &self,
        nodes: &SharedList<Node>,
        frame: f64,
        group: &mut Group,
        states: &mut [NodeState],
        warnings: &mut Warnings,
    ) -> bool {
        let clock = self.clock.as_ref();
        let clock = clock.and_then(|(at, channel)| nodes[*at].keys.track(channel));
        let found = clock.map_or(Some((0, 0.0)), |track| {
            track.straight(frame, &mut group.hint)
        });
        let Some((section, share)) = found else {
            return false;
        };
        for lane in 0..self.head.count {
            states[self.head.nodes[lane]].begin(self.looks[lane]);
        }
        let from = &self.sections[section];
        let keys = [from, self.sections.get(section + 1).unwrap_or(from)];
        let shares = self.head.shares.map(|row| row.map(|moves| share * moves));
        place_widest(&self.head, keys, &shares, &mut group.own, states, warnings);
        true
    }
}

/// The nodes of a scene, and what is prepared of them until one changes.
#[derive(Debug, Default)]
pub(super) struct Nodes {
    all: SharedList<Node>,
    asked: AtomicUsize,
    packs: OnceLock<Vec<Option<Pack>>>,
    /// Whether [`super::Scene::is_plain`], and whether none follows a path.
    pub plain: OnceLock<(bool, bool)>,
    /// The first and the last frame of all that moves.
    pub frames: OnceLock<Option<(f64, f64)>>,
}

/// The factor by which gathering numbers costs less than packing them and gathering nothing.
const PACKING: usize = 16;

impl Nodes {
    /// A node whose parent and aim stay: what is prepared of nodes in other groups stays too.
    pub(super) fn one(&mut self, at: usize, order: &[usize]) -> &mut Node {
        self.forget(at, order);
        &mut self.all[at]
    }

    /// Puts another one in its place, with the same parent and aim.
    pub(super) fn put(&mut self, at: usize, node: Arc<Node>, order: &[usize]) {
        self.forget(at, order);
        self.all.set(at, node);
    }

    fn forget(&mut self, at: usize, order: &[usize]) {
        (self.plain, self.frames) = Default::default();
        if let Some(packs) = self.packs.get_mut()
            && !packs.is_empty()
            && let Some(place) = order.iter().position(|&node| node == at)
            && let Some(pack) = packs.get_mut(place / GROUP)
        {
            *pack = None;
        }
    }

    /// A node whose path and keys stay: so do the frames of all.
    pub(super) fn still(&mut self, at: usize) -> &mut Node {
        let frames = std::mem::take(&mut self.frames);
        *self = std::mem::take(&mut self.all).into();
        self.frames = frames;
        &mut self.all[at]
    }

    /// A pack for each [`GROUP`] in this order that can have one, or none at all: they are made when
    /// as much has been gathered as they cost. Without memory for them it goes on without.
    pub(super) fn packs(&self, order: &[usize], numbers: usize) -> &[Option<Pack>] {
        if let Some(packs) = self.packs.get() {
            return packs;
        }
        let asked = self.asked.fetch_add(1, Ordering::Relaxed);
        if asked.saturating_mul(PACKING * self.all.len()) < numbers {
            return &[];
        }
        let all = || Pack::all(&self.all, order, 0).unwrap_or_default();
        self.packs.get_or_init(all)
    }
}

impl From<SharedList<Node>> for Nodes {
    fn from(all: SharedList<Node>) -> Self {
        Self {
            all,
            ..Self::default()
        }
    }
}

impl Clone for Nodes {
    fn clone(&self) -> Self {
        self.all.clone().into()
    }
}

impl PartialEq for Nodes {
    fn eq(&self, other: &Self) -> bool {
        self.all == other.all
    }
}

impl Deref for Nodes {
    type Target = SharedList<Node>;
    fn deref(&self) -> &SharedList<Node> {
        &self.all
    }
}

/// A change of a node must rebuild what is prepared.
impl DerefMut for Nodes {
    fn deref_mut(&mut self) -> &mut SharedList<Node> {
        *self = std::mem::take(&mut self.all).into();
        &mut self.all
    }
}

#[cfg(test)]
#[path = "side_by_side_tests.rs"]
mod tests;

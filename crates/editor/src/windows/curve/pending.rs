//! What was entered into the curve window and is pending (thesis A.4.1). No egui here.
//!
//! Only what was entered is pending: the rest follows the document. So a point that is dragged
//! while the window is open shows its new place, and applying changes only what was entered.

use glam::DVec3;
use vides_document::{At, Document, Edit, Selection, no_longer_ahead};
use vides_engine::limits::PRESETS;
use vides_engine::path::{CurveParameters, Orientation, SupportPoint, Target, Tcb};

/// Where the parameters come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CurveSource {
    /// `Standard n`.
    Preset(usize),
    /// `Eigendef.`
    Own,
}

/// Values to be applied to the current point and orientation.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Pending {
    pub(crate) choice: Option<CurveSource>,
    pub(crate) presets: [Option<Tcb>; PRESETS],
    pub(crate) own: Option<Tcb>,
    /// The own values come from changing this preset, which other points use too.
    pub(crate) shared: Option<usize>,
    pub(crate) position: [Option<f64>; 3],
    pub(crate) target: [Option<f64>; 3],
    pub(crate) roll: Option<f64>,
}

impl Pending {
    pub(crate) fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    pub(crate) fn choice(&self, document: &Document) -> CurveSource {
        self.choice.unwrap_or_else(|| match point(document).curve {
            CurveParameters::Preset(preset) => CurveSource::Preset(preset.into()),
            CurveParameters::Own(_) => CurveSource::Own,
        })
    }

    /// Chooses a preset, or own values that begin as those in force.
    pub(crate) fn choose(&mut self, document: &Document, choice: CurveSource) {
        if choice == CurveSource::Own && self.own.is_none() {
            let known = matches!(point(document).curve, CurveParameters::Own(_));
            self.own = (!known).then(|| self.tcb(document));
        }
        self.choice = Some(choice);
        self.shared = None;
    }

    /// The preset whose change could be meant for all points that use it, and whether it is.
    pub(crate) fn for_all(&self, document: &Document) -> Option<(usize, bool)> {
        let shared = self.shared?;
        let all = self.choice(document) == CurveSource::Preset(shared);
        Some((shared, all))
    }

    /// Gives the changed values to the preset, for all points that use it, or to this point alone.
    pub(crate) fn mean_all(&mut self, document: &Document, all: bool) {
        let (Some(shared), tcb) = (self.shared, self.tcb(document)) else {
            return;
        };
        if let Some(preset) = self.presets.get_mut(shared) {
            *preset = all.then_some(tcb);
            self.own = (!all).then_some(tcb);
            self.choice = Some(if all {
                CurveSource::Preset(shared)
            } else {
                CurveSource::Own
            });
        }
    }

    /// The parameters that the sliders show.
    pub(crate) fn tcb(&self, document: &Document) -> Tcb {
        let in_force = document.path().tcb(document.selection().point);
        match self.choice(document) {
            CurveSource::Own => self.own.unwrap_or(in_force),
            CurveSource::Preset(preset) => self.preset(document, preset),
        }
    }

    pub(crate) fn preset(&self, document: &Document, preset: usize) -> Tcb {
        let pending = self.presets.get(preset).copied().flatten();
        let known = || document.path().presets.get(preset).copied();
        pending.or_else(known).unwrap_or_default()
    }

    /// Changes the parameters that the sliders show.
    pub(crate) fn set_tcb(&mut self, document: &Document, tcb: Tcb) {
        match self.choice(document) {
            CurveSource::Own => self.own = Some(tcb),
            CurveSource::Preset(preset) => {
                let asked = self.shared == Some(preset);
                if !asked && users(document, preset) > 1 {
                    self.shared = Some(preset);
                    (self.choice, self.own) = (Some(CurveSource::Own), Some(tcb));
                } else if let Some(pending) = self.presets.get_mut(preset) {
                    *pending = Some(tcb);
                }
            }
        }
    }

    pub(crate) fn position(&self, document: &Document) -> [f64; 3] {
        merged(self.position, point(document).position.to_array())
    }

    /// The target (absolute) or offset (relative) that the fields show.
    pub(crate) fn target(&self, document: &Document) -> [f64; 3] {
        let (Target::Absolute(target) | Target::Relative(target)) = aimed(document).target;
        merged(self.target, target.to_array())
    }

    pub(crate) fn roll(&self, document: &Document) -> f64 {
        self.roll.unwrap_or_else(|| orientation(document).roll)
    }

    /// Whether it gives the current point a shape.
    pub(super) fn shapes(&self) -> bool {
        self.choice.is_some() || self.own.is_some()
    }

    /// The edits that apply it, in an order in which each is possible if the outcome is.
    pub(crate) fn edits(&self, document: &Document) -> Vec<Edit> {
        let Selection {
            point: at,
            orientation: number,
        } = document.selection();
        let mut edits = Vec::new();
        if self.presets.iter().any(Option::is_some) {
            let mut presets = document.path().presets;
            for (preset, pending) in presets.iter_mut().zip(self.presets) {
                *preset = pending.unwrap_or(*preset);
            }
            edits.push(Edit::set(At::Path, "presets", presets));
        }
        if self.shapes() {
            let shape = match self.choice(document) {
                CurveSource::Preset(preset) => Edit::set(At::Point(at), "preset", preset),
                CurveSource::Own => Edit::set(At::Point(at), "own", self.tcb(document)),
            };
            edits.extend(Edit::shaped(document.path(), at, shape));
        }
        let moves = self.position.iter().any(Option::is_some);
        let turns = self.target.iter().any(Option::is_some) || self.roll.is_some();
        let mut orientation = if self.target.iter().any(Option::is_some) {
            aimed(document)
        } else {
            orientation(document).clone()
        };
        if moves && turns && matches!(orientation.target, Target::Absolute(_)) {
            // The new position may be the old target, or the new target the old position: meanwhile
            // the target moves along.
            edits.push(Edit::SetAbsolute {
                point: at,
                at: number,
                absolute: false,
            });
        }
        if moves {
            edits.push(Edit::set(
                At::Point(at),
                "position",
                DVec3::from(self.position(document)),
            ));
        }
        if turns {
            let target = self.target(document).into();
            orientation.target = match orientation.target {
                Target::Absolute(_) => Target::Absolute(target),
                Target::Relative(_) => Target::Relative(target),
            };
            orientation.roll = self.roll(document);
            edits.push(Edit::SetOrientation {
                point: at,
                at: number,
                orientation,
            });
        }
        edits
    }
}

/// Points that will use a preset, the current one counted.
pub(crate) fn users(document: &Document, preset: usize) -> usize {
    let current = document.selection().point;
    let points = document.path().points.iter().enumerate();
    let uses = |curve| matches!(curve, CurveParameters::Preset(p) if usize::from(p) == preset);
    points
        .filter(|(number, point)| *number == current || uses(point.curve))
        .count()
}

pub(crate) fn point(document: &Document) -> &SupportPoint {
    &document.path().points[document.selection().point]
}

pub(crate) fn orientation(document: &Document) -> &Orientation {
    &point(document).orientations[document.selection().orientation]
}

/// The same; one that looks along the path has the target it looks at.
fn aimed(document: &Document) -> Orientation {
    let Selection {
        point,
        orientation: at,
    } = document.selection();
    let aimed = no_longer_ahead(document.path(), point, at);
    aimed.unwrap_or_else(|_| orientation(document).clone())
}

fn merged(pending: [Option<f64>; 3], known: [f64; 3]) -> [f64; 3] {
    let [a, b, c] = pending;
    let [x, y, z] = known;
    [a.unwrap_or(x), b.unwrap_or(y), c.unwrap_or(z)]
}

/// What pending values belong to; when that changes they are given up.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Belonging {
    selection: Selection,
    points: usize,
    orientations: usize,
    absolute: bool,
    state: u64,
    newest: u64,
}

/// Why pending values were given up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum GivenUp {
    /// Another point or orientation is current.
    Elsewhere,
    /// Undo, redo, another path, an orientation that became absolute.
    Changed,
}

impl Belonging {
    pub(crate) fn of(document: &Document) -> Self {
        Self {
            selection: document.selection(),
            points: document.path().points.len(),
            orientations: point(document).orientations.len(),
            absolute: matches!(orientation(document).target, Target::Absolute(_)),
            state: document.state_number(),
            newest: document.state_number(),
        }
    }

    /// What it belonged to was replaced as a whole.
    pub(crate) fn lose(&mut self) {
        // Whatever state comes now looks like an earlier one.
        (self.state, self.newest) = (u64::MAX, u64::MAX);
    }

    /// Brings it up to date; returns why it was discarded, if so.
    pub(crate) fn follow(&mut self, document: &Document) -> Option<GivenUp> {
        let mut now = Self::of(document);
        if self.newest != u64::MAX {
            now.newest = self.newest.max(now.state);
        }
        // An edit has a new number; only undo, redo and another document come with an old one.
        let back = now.state != self.state && now.state <= self.newest;
        let gone = if now.selection != self.selection {
            Some(GivenUp::Elsewhere)
        } else if back
            || now.points != self.points
            || now.orientations != self.orientations
            || now.absolute != self.absolute
        {
            Some(GivenUp::Changed)
        } else {
            None
        };
        *self = now;
        gone
    }
}

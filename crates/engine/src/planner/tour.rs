//! A flight that shows an object: candidate views around it or in it,
//! the fewest of them that show enough, a short round that keeps clear, a smooth path at a pace
//! within limits.

mod cover;
mod depths;
mod flight;
mod lead;
mod places;
mod request;
mod round;
mod seen;

use glam::DVec3;

use self::cover::fewest;
use self::places::{View, is_steep};
pub use self::request::{Tour, TourRequest};
use self::round::Roads;
use self::seen::{Camera, Picture, Set, Surface, members};
use super::directions::directions;
use super::retime::{Request, retime};
use crate::deform::Bounds;
use crate::error::{Error, Invalid, OutOfRange, Result, vec_with_room};
use crate::limits::TOUR_DISTANCES;
use crate::path::Timeline;
use crate::scene::Mesh;
use crate::tools::check::{FindingKind, Limits};
use crate::tools::clearance::Clearance;
use crate::tools::fit::Progress;
use crate::tools::watch::Watch;

/// The default distance, as a multiple of half the height, or half the diagonal of the ground,
/// so that these are whole in the picture with a tenth to spare.
const FIT: [f64; 2] = [2.2, 1.47];

/// Ways keep this share of the distance away, the curve this one.
const CLEAR: [f64; 2] = [0.8, 0.7];

/// The focal length.
const ZOOM: f64 = 24.0;

/// More triangles than this have fewer places tried.
const MANY: f64 = 250_000.0;

/// Places tried for what no other shows.
const MORE: usize = 100;

/// How many triangles propose views, and in how many directions.
const ASKED: usize = 1500;
const WAYS: usize = 96;

/// The highest multiple of the mean speed that is requested, unless more is required.
const EVEN: f64 = 1.25;

/// A flight that shows as much of an object's surface as is asked for. Outside only the side that
/// normals point to counts where neighbouring triangles agree about it, else either does, as inside.
///
/// `progress` gets pictures done and all of them.
///
/// # Errors
/// [`crate::Error::Argument`] for numbers that will not do, an object without a surface, a start
/// that is not free or from where nothing is reached, no free place inside, too few seconds (the
/// error names the least), or where `progress` ends it; [`crate::Error::Range`],
/// [`crate::Error::Limit`], [`crate::Error::Memory`].
pub fn tour(object: &Mesh, request: &TourRequest, progress: Progress<'_>) -> Result<Tour> {
    request.check()?;
    object.check()?;
    if object.triangles.is_empty() {
        return Err(Invalid::NoSurface.into());
    }
    let tree = Clearance::new(object)?;
    let watch = &Watch::new(progress);
    let mut work = Work::new(object, &tree, request, watch)?;
    work.find_views()?;
    let roads = work.roads()?;
    work.keep_reached(&roads)?;
    let unseen = work.unseen()?;
    let mut chosen = work.choose(unseen.visible)?;
    work.aim(&mut chosen)?;
    let shown = work.shown(chosen.iter().map(|(_, set)| set))?;
    let flight = work.flight(&roads, &chosen)?;
    let places = flight.stops.iter().filter(|stop| !stop.targets.is_empty());
    let places = places.count() - usize::from(request.start.is_some());
    let total = work.surface.total;
    let mut made = Tour {
        coverage: (shown / unseen.visible).min(1.0),
        surface: shown / total,
        places,
        distance: work.surface.distance,
        length: 0.0,
        seconds: 0.0,
        left_out: (unseen.tried - shown).max(0.0) / total,
        narrow: (unseen.visible - unseen.tried) / total,
        hidden: (1.0 - unseen.visible / total).max(0.0),
        path: work.path(flight)?,
    };
    made.length = Timeline::new(&made.path)?.length();
    made.seconds = if request.stills {
        chosen.len() as f64 / request.fps
    } else {
        work.pace(&mut made)?
    };
    Ok(made)
}

/// Areas: what views that were tried show, and what might be seen.
struct Unseen {
    tried: f64,
    visible: f64,
}

struct Work<'a> {
    request: &'a TourRequest,
    tree: &'a Clearance,
    watch: &'a Watch<'a>,
    surface: Surface<'a>,
    picture: Picture,
    bounds: Bounds,
    /// Half the diagonal of the object.
    half: f64,
    /// No place is nearer to the object.
    least: f64,
    places: Vec<DVec3>,
    views: Vec<View>,
    sets: Vec<Set>,
    /// Of what was asked, the area that might be seen, and all of it.
    asked: [f64; 2],
}

impl<'a> Work<'a> {
    fn new(
        object: &'a Mesh,
        tree: &'a Clearance,
        request: &'a TourRequest,
        watch: &'a Watch<'a>,
    ) -> Result<Self> {
        let surface = Surface::new(object, request.inside)?;
        let corners = object.triangles.iter().flatten();
        let start = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (low, high) = corners
            .map(|at| object.points[*at as usize])
            .fold(start, |(low, high), place| {
                (low.min(place), high.max(place))
            });
        let bounds = Bounds::new(low, high)?;
        let half = 0.5 * (high - low).length();
        if request.distance > TOUR_DISTANCES[1] * half
            || (request.distance > 0.0 && request.distance < TOUR_DISTANCES[0] * half)
        {
            return Err(OutOfRange::TourDistance.into());
        }
        let picture = Picture::new(&surface)?;
        let mut made = Self {
            request,
            tree,
            watch,
            surface,
            picture,
            bounds,
            half,
            least: 0.0,
            places: Vec::new(),
            views: Vec::new(),
            sets: Vec::new(),
            asked: [0.0; 2],
        };
        made.set_distance(if request.distance > 0.0 {
            request.distance
        } else {
            let size = 0.5 * request.up.upright(high - low);
            (FIT[0] * size.y).max(FIT[1] * size.x.hypot(size.z))
        });
        Ok(made)
    }

    fn set_distance(&mut self, distance: f64) {
        self.surface.distance = distance;
        let limit = self.request.limits.get(FindingKind::Clearance);
        let room = if self.request.inside { 0.0 } else { distance };
        let size = self
            .request
            .space
            .map_or(1.2 * (self.half + room), |space| space.half_size);
        let near = if limit.is_finite() {
            1.5 * limit * size
        } else {
            0.0
        };
        self.least = near.max(0.05 * distance).min(0.8 * distance);
    }

    /// The views that are tried, and what each shows.
    fn find_views(&mut self) -> Result<()> {
        (self.places, self.views) = if self.request.inside {
            let least = self.least.min(0.02 * self.half);
            let up = self.request.up;
            let (places, views, widest) =
                places::inside(self.tree, &self.bounds, least, up, self.watch)?;
            if views.is_empty() {
                return Err(Invalid::NoRoomInside.into());
            }
            if self.request.distance == 0.0 {
                self.set_distance(2.0 * widest);
            }
            self.least = self.least.min(0.2 * widest);
            (places, views)
        } else {
            let up = (self.request.up, self.effort());
            places::outside(
                self.tree,
                &self.bounds,
                self.surface.distance,
                up,
                self.watch,
            )?
        };
        let all = self.views.len() + MORE;
        self.sets.try_reserve(all)?;
        for at in 0..self.views.len() {
            self.watch.at(at, all)?;
            let set = self.look(self.views[at])?;
            self.sets.push(set);
        }
        self.ask(all)
    }

    /// Fewer places are tried for a surface of very many triangles, which takes long.
    fn effort(&self) -> f64 {
        let count = self.surface.areas.len() as f64;
        (MANY / count).sqrt().clamp(0.4, 1.0)
    }

    fn camera(&self, view: View) -> Option<Camera> {
        Camera::new(self.places[view.at], view.target, self.request.up, ZOOM)
    }

    fn look(&mut self, view: View) -> Result<Set> {
        let mut set = self.surface.nothing()?;
        if let Some(camera) = self.camera(view) {
            self.picture.look(&self.surface, &camera, &mut set);
        }
        Ok(set)
    }

    /// Tries more places for what no view shows yet, and finds how much of that might be seen.
    fn ask(&mut self, all: usize) -> Result<()> {
        let mut seen = self.union(self.sets.iter())?;
        let count = self.surface.areas.len();
        let left = count - members(&seen).count();
        let mut more = 0;
        let step = left.div_ceil(ASKED).max(1);
        let mut open = vec_with_room(left / step + 1)?;
        open.extend(
            (0..count)
                .filter(|at| seen[at / 64] >> (at % 64) & 1 == 0)
                .step_by(step),
        );
        let is_seen = |seen: &Set, at: usize| seen[at / 64] >> (at % 64) & 1 == 1;
        let mut found = vec_with_room(open.len())?;
        for at in open {
            self.watch.at(all - MORE + more, all)?;
            let eyes = self.seen_from(at);
            if let (Some(Some(eye)), true) = (&eyes, more < MORE && !is_seen(&seen, at)) {
                let view = View {
                    at: self.places.len(),
                    target: self.surface.middles[at],
                };
                self.places.try_reserve(1)?;
                self.views.try_reserve(1)?;
                self.places.push(*eye);
                self.views.push(view);
                let set = self.look(view)?;
                seen.iter_mut().zip(&set).for_each(|(all, own)| *all |= own);
                self.sets.push(set);
                more += 1;
            }
            found.push((at, eyes.is_some()));
        }
        for (at, visible) in found {
            if !is_seen(&seen, at) {
                let area = self.surface.areas[at];
                self.asked[1] += area;
                self.asked[0] += if visible { area } else { 0.0 };
            }
        }
        Ok(())
    }

    /// Whether a triangle might be seen from anywhere, and a place for a camera, if there is one.
    fn seen_from(&self, at: usize) -> Option<Option<DVec3>> {
        let (middle, normal) = (self.surface.middles[at], self.surface.across[at]);
        let distance = self.surface.distance;
        if self.request.inside {
            let towards = |eye: &DVec3| {
                let way = *eye - middle;
                let near = 1e-6 * self.half / way.length();
                self.surface.faces(at, *eye)
                    && !is_steep(*eye, middle, self.request.up)
                    && !self.tree.is_crossed(middle + near * way, *eye)
            };
            let step = self.places.len().div_ceil(WAYS);
            let from = self.places.iter().step_by(step).find(|eye| towards(eye));
            return from.map(|eye| Some(*eye));
        }
        let facing = |way: &DVec3| {
            let share = normal.dot(*way) / self.surface.areas[at];
            if self.surface.one_sided {
                share
            } else {
                share.abs()
            }
        };
        let near = 1e-6 * self.half;
        let free = |way: &DVec3| {
            self.watch.goes_on()
                && facing(way) > 0.1
                && !self.tree.is_met(middle + near * way, *way)
        };
        let mut best: Option<(f64, DVec3)> = None;
        let mut visible = false;
        for way in directions(WAYS).filter(free) {
            visible = true;
            for far in [1.0, 0.5, 1.5].map(|share| share * distance) {
                let eye = middle + far * way;
                let share = facing(&way);
                if best.is_none_or(|(most, _)| share > most)
                    && !is_steep(eye, middle, self.request.up)
                    && self.tree.distance(eye, 1.2 * self.least).is_none()
                {
                    best = Some((share, eye));
                    break;
                }
            }
        }
        visible.then(|| best.map(|(_, eye)| eye))
    }

    fn union<'s>(&self, sets: impl Iterator<Item = &'s Set>) -> Result<Set> {
        let mut all = self.surface.nothing()?;
        for set in sets {
            all.iter_mut().zip(set).for_each(|(all, own)| *all |= own);
        }
        Ok(all)
    }

    /// The area that some sets have together.
    fn shown<'s>(&self, sets: impl Iterator<Item = &'s Set>) -> Result<f64> {
        Ok(self.surface.area_of(&self.union(sets)?))
    }

    fn roads(&self) -> Result<Roads<'a>> {
        let mut places = vec_with_room(self.places.len() + 1)?;
        places.extend_from_slice(&self.places);
        if let Some(start) = self.request.start {
            if self.tree.distance(start, self.least).is_some() {
                return Err(Invalid::TourStart.into());
            }
            places.push(start);
        }
        let middle = self.bounds.min() + 0.5 * (self.bounds.max() - self.bounds.min());
        let (clear, middle) = if self.request.inside {
            (self.least, None)
        } else {
            (
                (CLEAR[0] * self.surface.distance).max(self.least),
                Some(middle),
            )
        };
        let up = self.request.up.world(DVec3::Y);
        Roads::new((self.tree, self.watch), clear, up, middle, places)
    }

    /// Leaves out views from where there is no way to the most of them, or to the start.
    fn keep_reached(&mut self, roads: &Roads) -> Result<()> {
        let count = roads.places.len();
        let mut home: Vec<usize> = vec_with_room(count)?;
        home.resize(count, usize::MAX);
        for at in 0..count {
            if home[at] == usize::MAX {
                let (far, _) = roads.from(at)?;
                (0..count)
                    .filter(|k| far[*k] < f64::INFINITY)
                    .for_each(|k| home[k] = at);
            }
        }
        let size = |at: usize| self.views.iter().filter(|view| home[view.at] == at).count();
        let best = match self.request.start {
            Some(_) => home[count - 1],
            None => (0..count).rev().max_by_key(|at| size(*at)).unwrap_or(0),
        };
        let views = std::mem::take(&mut self.views);
        let sets = std::mem::take(&mut self.sets);
        for (view, set) in views.into_iter().zip(sets) {
            if home[view.at] == best && set.iter().any(|word| *word != 0) {
                self.views.push(view);
                self.sets.push(set);
            }
        }
        if self.views.is_empty() {
            let start = self.request.start.map(|_| Invalid::TourStart);
            return Err(start.unwrap_or(Invalid::TourNothing).into());
        }
        Ok(())
    }

    fn unseen(&self) -> Result<Unseen> {
        let tried = self.shown(self.sets.iter())?;
        let share = self.asked[0] / self.asked[1].max(f64::MIN_POSITIVE);
        let visible = tried + share * (self.surface.total - tried);
        Ok(Unseen { tried, visible })
    }

    /// The views that are taken, at least from two places.
    fn choose(&mut self, visible: f64) -> Result<Vec<(View, Set)>> {
        let wanted = self.request.coverage * visible;
        let mut taken = fewest(&self.sets, &self.surface.areas, wanted)?;
        // A round has three places; those that are not needed are far from the others, and show
        // half as much as the best at least.
        let area = |at: usize| self.surface.area_of(&self.sets[at]);
        let most = taken.iter().fold(0.0, |most: f64, at| most.max(area(*at)));
        let least = if self.request.start.is_some() { 1 } else { 3 };
        let place = |at: usize| self.places[self.views[at].at];
        taken.try_reserve(least)?;
        let places = |taken: &[usize]| {
            // The first view from each place.
            let own = |k: &usize| taken[..*k].iter().all(|at| place(*at) != place(taken[*k]));
            (0..taken.len()).filter(own).count()
        };
        for _ in 0..least {
            if places(&taken) >= least {
                break;
            }
            let apart = |at: usize| {
                let near = taken.iter().map(|other| place(*other).distance(place(at)));
                near.fold(f64::INFINITY, f64::min)
            };
            let others = (0..self.views.len())
                .rev()
                .filter(|at| apart(*at) > 0.0 && area(*at) >= 0.5 * most);
            let farthest = others.max_by(|a, b| apart(*a).total_cmp(&apart(*b)));
            taken.extend(farthest);
        }
        if places(&taken) < least.min(2) {
            return Err(Invalid::TourNothing.into());
        }
        let mut chosen = vec_with_room(taken.len())?;
        chosen.extend(
            taken
                .iter()
                .map(|at| (self.views[*at], std::mem::take(&mut self.sets[*at]))),
        );
        Ok(chosen)
    }

    /// Turns each view to the middle of what it shows, where all together then show as much.
    fn aim(&mut self, chosen: &mut [(View, Set)]) -> Result<()> {
        let before = self.shown(chosen.iter().map(|(_, set)| set))?;
        for k in 0..chosen.len() {
            let (old, set) = &chosen[k];
            let in_set = |at: usize| set[at / 64] >> (at % 64) & 1 == 1;
            let Some(target) = self.surface.middle_of(in_set) else {
                continue;
            };
            let view = View { target, ..*old };
            if is_steep(self.places[view.at], target, self.request.up) {
                continue;
            }
            let last = std::mem::replace(&mut chosen[k], (view, self.look(view)?));
            if self.shown(chosen.iter().map(|(_, set)| set))? < before {
                chosen[k] = last;
            }
        }
        Ok(())
    }

    /// Gives a tour's path a pace, as even as the limits allow; returns the seconds.
    fn pace(&self, tour: &mut Tour) -> Result<f64> {
        let mut limits = self.request.limits;
        let mean = tour.length / tour.path.space.half_size / self.request.seconds;
        let speed = limits.get(FindingKind::Speed).min(EVEN * mean);
        limits.set(FindingKind::Speed, speed)?;
        let views = self.views.len();
        let paced = |limits: Limits| {
            let request = Request {
                limits,
                fps: self.request.fps,
                points: None,
                seconds: self.request.seconds,
            };
            let go_on = &mut |_, _| self.watch.at(views, views).is_ok();
            retime(&tour.path, &request, go_on)
        };
        let made = match paced(limits) {
            Err(Error::Argument(cause)) if cause != Invalid::Cancelled => {
                paced(self.request.limits)?
            }
            made => made?,
        };
        tour.path = made.path;
        Ok(made.seconds)
    }
}

#[cfg(test)]
#[path = "tour_tests.rs"]
mod tests;

//! What an object has, exchanged ([`super::part`]): its mesh, its shapes, its deformations.

use std::mem::swap;

use super::channel::Channel;
use super::mesh::{Object, Shape};
use super::node::{Kind, Node};
use super::part::Part;
use super::track::Track;
use crate::error::{Invalid, OutOfRange, Result, try_arc};

impl Part {
    /// A new shape for an object, with weight 0.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn insert_shape(node: usize, at: usize, shape: Shape) -> Result<Self> {
        Ok(Self::InsertShape {
            node,
            at,
            shape: try_arc(shape)?,
            weight: 0.0,
            weights: Vec::new(),
        })
    }
}

impl Node {
    pub(super) fn exchange_of_object(&mut self, part: &mut Part) -> Result<()> {
        match part {
            Part::Mesh { mesh, .. } => self.object_of()?.exchange_mesh(mesh),
            Part::Weights { weights, .. } => self.object_of()?.exchange_weights(weights),
            Part::InsertShape {
                node,
                at,
                shape,
                weight,
                weights,
            } => {
                let (node, at) = (*node, *at);
                self.object_of()?.check_new_shape(at, shape, *weight)?;
                if let Some(track) = self.keys.track_mut(&Channel::Weights) {
                    track
                        .insert_column(at, weights)
                        .map_err(|error| track.at_channel(error))?;
                }
                self.object_of()?.insert_shape(at, shape.clone(), *weight);
                *part = Part::RemoveShape { node, at };
                Ok(())
            }
            Part::RemoveShape { node, at } => {
                let (node, at) = (*node, *at);
                let count = self.object_of()?.shapes().len();
                if at >= count {
                    return Err(OutOfRange::NoShape { at, count }.into());
                }
                let weights = match self.keys.track_mut(&Channel::Weights) {
                    Some(_) if count == 1 => return Err(Invalid::NoShapes.into()),
                    Some(track) => track.remove_column(at)?,
                    None => Vec::new(),
                };
                let (shape, weight) = self.object_of()?.remove_shape(at);
                *part = Part::InsertShape {
                    node,
                    at,
                    shape,
                    weight,
                    weights,
                };
                Ok(())
            }
            Part::InsertDeformation { .. }
            | Part::RemoveDeformation { .. }
            | Part::Deformation { .. }
            | Part::MoveDeformation { .. } => self.exchange_deformation(part),
            _ => Ok(()),
        }
    }

    fn object_of(&mut self) -> Result<&mut Object> {
        match &mut self.kind {
            Kind::Object(object) => Ok(object),
            _ => Err(Invalid::NoObject((&self.name).into()).into()),
        }
    }

    fn exchange_deformation(&mut self, part: &mut Part) -> Result<()> {
        match part {
            Part::InsertDeformation {
                node,
                at,
                deformation,
                bounds,
            } => {
                let new = (deformation.clone(), *bounds);
                self.object_of()?.insert_deformation(*at, new)?;
                let (node, at) = (*node, *at);
                self.renumber(|old| if old >= at { old + 1 } else { old });
                *part = Part::RemoveDeformation { node, at };
            }
            Part::RemoveDeformation { node, at } => {
                let (node, at) = (*node, *at);
                self.object_of()?.check_deformation(at)?;
                if let Some(track) = self.tracks_of(at).next() {
                    let channel = (&track.channel()).into();
                    return Err(Invalid::HasTrack { channel }.into());
                }
                let (deformation, bounds) = self.object_of()?.remove_deformation(at);
                self.renumber(|old| if old > at { old - 1 } else { old });
                *part = Part::InsertDeformation {
                    node,
                    at,
                    deformation,
                    bounds,
                };
            }
            Part::Deformation {
                at,
                deformation,
                bounds,
                ..
            } => {
                self.object_of()?.check_deformation(*at)?;
                for track in self.tracks_of(*at) {
                    if let Channel::Deformation { parameter, .. } = track.channel() {
                        let wanted = deformation.parameter(parameter)?.len();
                        if wanted != track.width() {
                            return Err(OutOfRange::TrackWidth {
                                channel: (&track.channel()).into(),
                                wanted,
                                given: track.width(),
                            }
                            .into());
                        }
                    }
                }
                let here = self.object_of()?.deformation_mut(*at);
                swap(&mut here.0, deformation);
                swap(&mut here.1, bounds);
            }
            Part::MoveDeformation { from, to, .. } => {
                let object = self.object_of()?;
                object.check_deformation(*from)?;
                object.check_deformation(*to)?;
                object.move_deformation(*from, *to);
                let (from, to) = (*from, *to);
                self.renumber(|old| match old {
                    old if old == from => to,
                    old if from < old && old <= to => old - 1,
                    old if to <= old && old < from => old + 1,
                    old => old,
                });
                if let Part::MoveDeformation { from, to, .. } = part {
                    swap(from, to);
                }
            }
            _ => {}
        }
        Ok(())
    }

    /// The tracks of a deformation.
    pub fn tracks_of(&self, deformation: usize) -> impl Iterator<Item = &Track> {
        let tracks = self.keys.tracks().iter();
        tracks.filter(move |track| {
            matches!(track.channel(), Channel::Deformation { at, .. } if *at == deformation)
        })
    }

    fn renumber(&mut self, number: impl Fn(usize) -> usize) {
        self.keys.keep(|track| {
            track.renumber_deformation(&number);
            true
        });
    }
}

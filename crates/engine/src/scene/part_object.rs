//! Parts of what an object has ([`super::part`]): its mesh, its shapes, its deformations.

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
        })
    }
}

impl Node {
    pub(super) fn apply_to_object(&mut self, part: Part) -> Result<()> {
        match part {
            Part::Mesh { mesh, .. } => self.object_of()?.put_mesh(mesh),
            Part::Weights { weights, .. } => self.object_of()?.set_weights(&weights),
            Part::InsertShape { at, shape, .. } => {
                self.object_of()?.check_new_shape(at, &shape)?;
                self.change_weights(|track| track.insert_column(at))?;
                self.object_of()?.insert_shape(at, shape);
                Ok(())
            }
            Part::RemoveShape { at, .. } => {
                let count = self.object_of()?.shapes().len();
                if at >= count {
                    return Err(OutOfRange::NoShape { at, count }.into());
                }
                if count == 1 && self.keys.track(&Channel::Weights).is_some() {
                    return Err(Invalid::NoShapes.into());
                }
                self.change_weights(|track| track.remove_column(at))?;
                self.object_of()?.remove_shape(at);
                Ok(())
            }
            deformations => self.apply_to_deformations(deformations),
        }
    }

    fn change_weights(&mut self, change: impl FnOnce(&mut Track) -> Result<()>) -> Result<()> {
        match self.keys.track_mut(&Channel::Weights) {
            Some(track) => change(track).map_err(|error| track.at_channel(error)),
            None => Ok(()),
        }
    }

    fn object_of(&mut self) -> Result<&mut Object> {
        match &mut self.kind {
            Kind::Object(object) => Ok(object),
            _ => Err(Invalid::NoObject((&self.name).into()).into()),
        }
    }

    fn apply_to_deformations(&mut self, part: Part) -> Result<()> {
        match part {
            Part::InsertDeformation {
                at,
                deformation,
                bounds,
                ..
            } => {
                self.object_of()?
                    .insert_deformation(at, (deformation, bounds))?;
                self.renumber(|old| if old >= at { old + 1 } else { old });
            }
            Part::RemoveDeformation { at, .. } => {
                self.object_of()?.check_deformation(at)?;
                if let Some(track) = self.tracks_of(at).next() {
                    let channel = (&track.channel()).into();
                    return Err(Invalid::HasTrack { channel }.into());
                }
                self.object_of()?.remove_deformation(at);
                self.renumber(|old| if old > at { old - 1 } else { old });
            }
            Part::Deformation {
                at,
                deformation,
                bounds,
                ..
            } => {
                self.object_of()?.check_deformation(at)?;
                for track in self.tracks_of(at) {
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
                *self.object_of()?.deformation_mut(at) = (deformation, bounds);
            }
            Part::MoveDeformation { from, to, .. } => {
                let object = self.object_of()?;
                object.check_deformation(from)?;
                object.check_deformation(to)?;
                object.move_deformation(from, to);
                self.renumber(|old| match old {
                    old if old == from => to,
                    old if from < old && old <= to => old - 1,
                    old if to <= old && old < from => old + 1,
                    old => old,
                });
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
        self.keys.renumber_deformations(number);
    }
}

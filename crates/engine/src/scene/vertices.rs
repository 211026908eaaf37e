//! The points of an object at a frame: morphed, then deformed (lecture 9.3).

use glam::DVec3;

use super::channel::Channel;
use super::mesh::{Object, Shape};
use super::node::{Kind, Node};
use super::state::Warnings;
use crate::deform::Deformation;
use crate::error::{Invalid, Result, vec_with_room};

/// Points morphed and deformed at once: they stay in the processor's cache.
const BLOCK: usize = 512;

/// An object's weights and deformations at one frame.
#[derive(Debug)]
pub struct Form<'a> {
    object: &'a Object,
    weights: Vec<f64>,
    deformations: Vec<Deformation>,
}

impl<'a> Form<'a> {
    pub(super) fn at(node: &'a Node, frame: f64, warnings: &mut Warnings) -> Result<Self> {
        let Kind::Object(object) = &node.kind else {
            return Err(Invalid::NoObject((&node.name).into()).into());
        };
        let mut form = Self {
            object,
            weights: vec_with_room(object.weights().len())?,
            deformations: vec_with_room(object.deformations().len())?,
        };
        form.weights.extend_from_slice(object.weights());
        for (deformation, _) in object.deformations() {
            let copy = Deformation::new(deformation.kind(), deformation.parameters())?;
            form.deformations.push(copy);
        }
        for track in node.keys.tracks() {
            match track.channel() {
                Channel::Weights => track.numbers(frame, &mut form.weights, warnings),
                Channel::Deformation { at, parameter } => {
                    let deformation = form.deformations.get_mut(*at);
                    if let Some(numbers) = deformation.and_then(|d| d.channel_mut(parameter)) {
                        track.numbers(frame, numbers, warnings);
                    }
                }
                _ => {}
            }
        }
        Ok(form)
    }

    /// Σ αⱼ Pʲ with Σ αⱼ = 1, the mesh taking what is left, then deformed; the rest of `out` stays.
    pub fn points(&self, out: &mut [DVec3]) {
        let base = &self.object.mesh().points;
        let left = 1.0 - self.weights.iter().sum::<f64>();
        let changes = self.active().next().is_some();
        let given = self.object.deformations();
        for (block, base) in base.chunks(BLOCK).enumerate() {
            let Some(out) = out
                .get_mut(block * BLOCK..)
                .and_then(|out| out.get_mut(..base.len()))
            else {
                return;
            };
            if changes {
                for (out, point) in out.iter_mut().zip(base) {
                    *out = left * *point;
                }
            } else {
                out.copy_from_slice(base);
            }
            for (weight, shape) in self.active() {
                for (out, point) in out.iter_mut().zip(&shape.points[block * BLOCK..]) {
                    *out += weight * *point;
                }
            }
            for (deformation, (_, bounds)) in self.deformations.iter().zip(given) {
                let bounds = bounds.unwrap_or_else(|| self.object.bounds());
                deformation.apply(&bounds, out);
            }
        }
    }

    /// The colours of the points, morphed likewise; empty if the mesh has none.
    pub(super) fn colours(&self) -> Result<Vec<[u8; 3]>> {
        let base = &self.object.mesh().colours;
        let mut colours = vec_with_room(base.len())?;
        let coloured = || self.active().filter(|(_, shape)| !shape.colours.is_empty());
        let left = 1.0 - coloured().map(|(weight, _)| weight).sum::<f64>();
        for (at, colour) in base.iter().enumerate() {
            colours.push(std::array::from_fn(|k| {
                let sum = coloured().fold(left * f64::from(colour[k]), |sum, (weight, shape)| {
                    sum + weight * f64::from(shape.colours[at][k])
                });
                sum.round().clamp(0.0, 255.0) as u8
            }));
        }
        Ok(colours)
    }

    fn active(&self) -> impl Iterator<Item = (f64, &Shape)> {
        let weights = self.weights.iter().copied();
        let shapes = self.object.shapes().iter().map(|shape| &**shape);
        weights.zip(shapes).filter(|(weight, _)| *weight != 0.0)
    }
}

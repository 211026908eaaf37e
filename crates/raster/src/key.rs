//! Recognises a primitive in the next frame.

use std::any::Any;
use std::sync::Arc;

use egui::epaint::Primitive;
use egui::{ClippedPrimitive, Mesh, Rect, TextureId};

use super::hash::{bits, mix, mix_two, pair};
use super::lines::Lines;
use super::rounded_rect::RoundedRect;
use super::texture::Textures;
use super::tile::PixelRect;

/// A primitive's identity.
pub(super) struct Key {
    clip: PixelRect,
    content: Content,
    /// Its texture has changed where the primitive shows it.
    changed: bool,
}

enum Content {
    Nothing,
    /// The hash of a mesh and its texture's identifier.
    Mesh(u64),
    /// [`Lines`] or a [`RoundedRect`].
    Ours(Arc<dyn Any + Send + Sync>),
}

fn same(a: &Arc<dyn Any + Send + Sync>, b: &Arc<dyn Any + Send + Sync>) -> bool {
    if let (Some(a), Some(b)) = (
        a.downcast_ref::<RoundedRect>(),
        b.downcast_ref::<RoundedRect>(),
    ) {
        return a.same_bits(b);
    }
    let (Some(a), Some(b)) = (a.downcast_ref::<Lines>(), b.downcast_ref::<Lines>()) else {
        return false;
    };
    a.same_bits(b)
}

impl PartialEq for Key {
    fn eq(&self, other: &Self) -> bool {
        self.clip == other.clip
            && self.changed == other.changed
            && match (&self.content, &other.content) {
                (Content::Nothing, Content::Nothing) => true,
                (Content::Mesh(a), Content::Mesh(b)) => a == b,
                // Callbacks that were rebuilt may still be equal.
                (Content::Ours(a), Content::Ours(b)) => Arc::ptr_eq(a, b) || same(a, b),
                _ => false,
            }
    }
}

impl Key {
    pub(super) fn new(
        primitive: &ClippedPrimitive,
        textures: &Textures,
        pixels_per_point: f32,
        target: PixelRect,
    ) -> Self {
        let mut clip = to_pixels_clipped(primitive.clip_rect, pixels_per_point, target);
        let content = match &primitive.primitive {
            Primitive::Mesh(mesh) => match textures.get(mesh.texture_id) {
                Some(_) => Content::Mesh(fingerprint(mesh)),
                None => Content::Nothing,
            },
            Primitive::Callback(callback) => {
                clip = clip.intersect(to_pixels_clipped(callback.rect, pixels_per_point, target));
                Content::Ours(Arc::clone(&callback.callback))
            }
        };
        Self {
            clip,
            content,
            changed: false,
        }
    }

    #[inline]
    pub(super) fn clip(&self) -> PixelRect {
        self.clip
    }

    /// The key to store with a layer, which shows the current texture.
    pub(super) fn settled(self) -> Self {
        Self {
            changed: false,
            ..self
        }
    }

    /// Makes the key unequal to all stored ones if the primitive's texture has changed.
    pub(super) fn with_changes_of(self, primitive: &ClippedPrimitive, textures: &Textures) -> Self {
        let changed = match &primitive.primitive {
            Primitive::Mesh(mesh) => textures
                .get(mesh.texture_id)
                .is_some_and(|texture| texture.is_changed_for(mesh)),
            Primitive::Callback(_) => false,
        };
        Self { changed, ..self }
    }
}

fn fingerprint(mesh: &Mesh) -> u64 {
    // Independent states, because each step waits for the one before.
    let texture = match mesh.texture_id {
        TextureId::Managed(number) => mix(0, number),
        TextureId::User(number) => mix(1, number),
    };
    let mut state = [texture, 1, 2, 3, 4];
    let mut vertices = mesh.vertices.chunks_exact(2);
    for two in &mut vertices {
        for (state, vertex) in state.iter_mut().zip(two) {
            let place = pair(vertex.pos.x, vertex.pos.y);
            *state = mix_two(*state, place, pair(vertex.uv.x, vertex.uv.y));
        }
        let colors = [bits(two[0].color), bits(two[1].color)];
        state[2] = mix(state[2], u64::from(colors[0]) << 32 | u64::from(colors[1]));
    }
    for vertex in vertices.remainder() {
        let place = pair(vertex.pos.x, vertex.pos.y);
        state[0] = mix_two(state[0], place, pair(vertex.uv.x, vertex.uv.y));
        state[2] = mix(state[2], u64::from(bits(vertex.color)));
    }
    let mut indices = mesh.indices.chunks_exact(4);
    for four in &mut indices {
        state[3] = mix_two(
            state[3],
            u64::from(four[0]) << 32 | u64::from(four[1]),
            u64::from(four[2]) << 32 | u64::from(four[3]),
        );
    }
    for &index in indices.remainder() {
        state[4] = mix(state[4], u64::from(index));
    }
    let counts = mix(mesh.vertices.len() as u64, mesh.indices.len() as u64);
    state.into_iter().fold(counts, mix)
}

/// The pixels of a rectangle in points, clipped to the target.
pub(super) fn to_pixels_clipped(rect: Rect, pixels_per_point: f32, target: PixelRect) -> PixelRect {
    let pixel = |at: f32| (at * pixels_per_point).round();
    let within = |at: f32, end: i32| at.clamp(0.0, end as f32) as i32;
    PixelRect {
        x0: within(pixel(rect.min.x), target.x1),
        y0: within(pixel(rect.min.y), target.y1),
        x1: within(pixel(rect.max.x), target.x1),
        y1: within(pixel(rect.max.y), target.y1),
    }
}

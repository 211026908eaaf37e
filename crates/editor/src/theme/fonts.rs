//! The fonts of the window: one for everything, and egui's few signs. egui's default adds a
//! monospaced one, 300 KB that nothing here is written in. They are packed in the library
//! (`build.rs`) and unpacked once in a process, for its first window.

use std::sync::{Arc, LazyLock};

use egui::{FontData, FontDefinitions};

/// The most bytes that a packed font unpacks to.
const LARGEST: usize = 1 << 20;

type Fonts = [(&'static str, Arc<FontData>); 2];

static FONTS: LazyLock<Fonts> = LazyLock::new(|| {
    [
        (
            "text",
            include_bytes!(concat!(env!("OUT_DIR"), "/text")).as_slice(),
        ),
        ("signs", include_bytes!(concat!(env!("OUT_DIR"), "/signs"))),
    ]
    .map(|(name, packed)| {
        let font = miniz_oxide::inflate::decompress_to_vec_with_limit(packed, LARGEST);
        // They were packed by us; a test unpacks them.
        (
            name,
            Arc::new(FontData::from_owned(font.unwrap_or_default())),
        )
    })
});

/// The fonts in the order in which a character is looked for.
pub(crate) fn definitions() -> FontDefinitions {
    let mut fonts = FontDefinitions::empty();
    for (name, data) in &*FONTS {
        fonts.font_data.insert((*name).to_owned(), Arc::clone(data));
        for family in fonts.families.values_mut() {
            family.push((*name).to_owned());
        }
    }
    fonts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_packed_comes_out_again() {
        let fonts = definitions();
        for (name, font) in [
            ("text", epaint_default_fonts::UBUNTU_LIGHT),
            ("signs", epaint_default_fonts::EGUI_ICONS),
        ] {
            assert!((*fonts.font_data[name].font).as_ref() == font, "{name}");
        }
    }
}

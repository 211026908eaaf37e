//! Pictures of the window's contents without a screen, for tests.

use std::path::PathBuf;

use egui::accesskit::Role;
use egui::{Color32, Rect, Shape, TexturesDelta};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{Harness, TestRenderer};
use image::RgbaImage;
use vides_raster::{Raster, Target};

/// Names the folder into which [`screenshot`] writes.
const FOLDER: &str = "VIDES_SCREENSHOTS";

struct Renderer(Raster);

/// A renderer for `egui_kittest` that paints as the window does:
/// `Harness::builder().renderer(renderer())`.
pub(crate) fn renderer() -> impl TestRenderer {
    Renderer(Raster::new(Color32::BLACK))
}

impl TestRenderer for Renderer {
    fn handle_delta(&mut self, delta: &mut TexturesDelta) {
        self.0.update_textures(std::mem::take(delta));
    }

    fn render(
        &mut self,
        context: &egui::Context,
        output: &egui::FullOutput,
    ) -> Result<RgbaImage, String> {
        let scale = output.pixels_per_point;
        let size = context.content_rect().size() * scale;
        let (width, height) = (size.x.round() as u32, size.y.round() as u32);
        let primitives = vides_raster::primitives(context, output.shapes.clone(), scale);
        let mut pixels = vec![0; width as usize * height as usize];
        self.0.forget();
        self.0.paint(
            &primitives,
            scale,
            &mut Target {
                pixels: &mut pixels,
                stride: width as usize,
                width,
                height,
            },
        );
        let bytes = pixels.iter().flat_map(|pixel| {
            let [_, r, g, b] = pixel.to_be_bytes();
            [r, g, b, 255]
        });
        RgbaImage::from_raw(width, height, bytes.collect()).ok_or_else(|| "no picture".to_owned())
    }
}

/// Texts that are painted beyond what they are clipped to at the left or right; what scrolls may be
/// cut above and below.
fn cut_texts(shape: &Shape, clip: Rect, cut: &mut Vec<(String, [Rect; 2])>) {
    match shape {
        Shape::Text(text) if text.angle == 0.0 => {
            let rect = text.visual_bounding_rect().shrink(1.0);
            let whole = clip.x_range();
            if clip.intersects(rect)
                && !(whole.contains(rect.left()) && whole.contains(rect.right()))
            {
                cut.push((text.galley.text().to_owned(), [rect, clip]));
            }
        }
        Shape::Vec(shapes) => shapes.iter().for_each(|shape| cut_texts(shape, clip, cut)),
        _ => {}
    }
}

/// What the harness shows now, with no text cut at its side. If the environment's
/// `VIDES_SCREENSHOTS` names a folder, it is written there too, as a PNG file of this name.
pub(crate) fn screenshot<State>(harness: &mut Harness<'_, State>, name: &str) -> RgbaImage {
    let mut cut = Vec::new();
    for clipped in &harness.output().shapes {
        cut_texts(&clipped.shape, clipped.clip_rect, &mut cut);
    }
    // What is typed into scrolls sideways.
    let typed = harness.query_all_by_role(Role::TextInput);
    let typed = typed.filter_map(|node| node.accesskit_node().value());
    let typed: Vec<String> = typed.collect();
    cut.retain(|(text, _)| !typed.contains(text));
    assert!(cut.is_empty(), "{name}: {cut:#?}");
    let image = harness.render().expect("our raster paints");
    if let Some(folder) = std::env::var_os(FOLDER) {
        let folder = PathBuf::from(folder);
        std::fs::create_dir_all(&folder).expect("a folder for pictures");
        image.save(folder.join(name)).expect("a picture written");
    }
    image
}

#[test]
fn a_busy_window() {
    use egui::pos2;
    use vides_raster::{Line, Lines};
    let mut text = "some text".to_owned();
    let mut number = 0.5;
    for scale in [1.0, 1.5] {
        let mut harness = Harness::builder()
            .with_size(egui::vec2(600.0, 400.0))
            .with_pixels_per_point(scale)
            .renderer(renderer())
            .build_ui(|ui| {
                egui::Panel::left("left").show(ui, |ui| {
                    ui.heading("A heading äöüß");
                    for i in 0..5 {
                        if ui.button(format!("Button {i}")).clicked() {
                            number = 0.0;
                        }
                    }
                    ui.add(egui::Slider::new(&mut number, 0.0..=1.0).text("slider"));
                    ui.text_edit_singleline(&mut text);
                    ui.checkbox(&mut true, "check");
                    ui.spinner();
                });
                egui::CentralPanel::default().show(ui, |ui| {
                    let rect = ui.max_rect();
                    let lines = (0..200)
                        .map(|i| {
                            let angle = i as f32 * 0.0314;
                            let middle = rect.center();
                            let line = |r| middle + r * egui::vec2(angle.cos(), angle.sin());
                            Line {
                                from: line(20.0),
                                to: line(150.0 + i as f32 * 0.2),
                                width: 0.5 + (i % 20) as f32 * 0.1,
                                color: Color32::from_rgb(200, 255 - i as u8, 80),
                            }
                        })
                        .collect();
                    let lines = std::sync::Arc::new(Lines { lines });
                    ui.painter().add(Lines::shape(&lines, rect.shrink(5.0)));
                    ui.painter()
                        .circle_filled(pos2(300.0, 50.0), 30.0, Color32::RED);
                    ui.painter()
                        .circle_stroke(pos2(400.0, 50.0), 30.0, (2.0, Color32::LIGHT_BLUE));
                });
            });
        harness.step();
        let image = screenshot(&mut harness, &format!("busy_{scale}.png"));
        let width = (600.0 * scale) as u32;
        assert_eq!(image.width(), width);
    }
}

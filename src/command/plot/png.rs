//! A plot as pixels, painted by the window's raster at twice the SVG's resolution.

use std::sync::Arc;

use egui::epaint::{PathShape, PathStroke};
use egui::{Align2, Color32, FontData, FontDefinitions, FontId, Rect, Shape, pos2, vec2};
use vides_raster::{Raster, Target, primitives};

use vides::plot::svg::{Anchor, Form, Mark, Spot, Svg};

/// Pixels per pixel of the SVG.
const FINE: f32 = 2.0;

/// Default font size.
const TEXT: f32 = 12.5;

/// The PNG of a picture.
pub(super) fn of(svg: &Svg) -> Result<Vec<u8>, String> {
    let size = vec2(svg.width as f32, svg.height as f32);
    let (width, height) = ((size.x * FINE).ceil() as u32, (size.y * FINE).ceil() as u32);
    let context = egui::Context::default();
    context.set_fonts(fonts());
    let screen = Rect::from_min_size(pos2(0.0, 0.0), size);
    let mut raster = Raster::new(colour(svg.ground));
    let input = || {
        let mut input = egui::RawInput {
            screen_rect: Some(screen),
            ..egui::RawInput::default()
        };
        let root = input.viewports.entry(egui::ViewportId::ROOT).or_default();
        root.native_pixels_per_point = Some(FINE);
        input
    };
    // Fonts and scale take effect from the second run on.
    let first = context.run_ui(input(), |_| {});
    raster.update_textures(first.textures_delta);
    let output = context.run_ui(input(), |ui| {
        let painter = ui.ctx().layer_painter(egui::LayerId::background());
        svg.marks.iter().for_each(|mark| draw(&painter, mark));
    });
    raster.update_textures(output.textures_delta);
    let all = primitives(&context, output.shapes, FINE);
    let mut pixels = vec![0; width as usize * height as usize];
    let mut target = Target {
        pixels: &mut pixels,
        stride: width as usize,
        width,
        height,
    };
    raster.paint(&all, FINE, &mut target);
    encoded(&pixels, width, height).map_err(|error| error.to_string())
}

fn encoded(pixels: &[u32], width: u32, height: u32) -> Result<Vec<u8>, ::png::EncodingError> {
    let mut file = Vec::new();
    let mut encoder = ::png::Encoder::new(&mut file, width, height);
    encoder.set_color(::png::ColorType::Rgb);
    let mut writer = encoder.write_header()?;
    let bytes = pixels.iter().flat_map(|pixel| {
        let [_, r, g, b] = pixel.to_be_bytes();
        [r, g, b]
    });
    writer.write_image_data(&bytes.collect::<Vec<u8>>())?;
    writer.finish()?;
    Ok(file)
}

fn fonts() -> FontDefinitions {
    let mut fonts = FontDefinitions::empty();
    let text = Arc::new(FontData::from_static(epaint_default_fonts::UBUNTU_LIGHT));
    fonts.font_data.insert("text".to_owned(), text);
    for family in fonts.families.values_mut() {
        family.push("text".to_owned());
    }
    fonts
}

fn attribute<'a>(attributes: &'a str, name: &str) -> Option<&'a str> {
    let begin = format!("{name}=\"");
    let mut words = attributes.split(&begin[..]);
    let before = words.next()?;
    let value = words.next()?;
    // Otherwise `name` is the end of a longer name.
    (before.is_empty() || before.ends_with(' ')).then_some(())?;
    value.split('"').next()
}

fn number(attributes: &str, name: &str, usual: f32) -> f32 {
    let value = attribute(attributes, name).and_then(|value| value.parse().ok());
    value.unwrap_or(usual)
}

/// Parses `#rrggbb`.
fn colour(text: &str) -> Color32 {
    let number = u32::from_str_radix(text.trim_start_matches('#'), 16).unwrap_or(0);
    let [_, r, g, b] = number.to_be_bytes();
    Color32::from_rgb(r, g, b)
}

fn draw(painter: &egui::Painter, mark: &Mark) {
    let attributes = &mark.attributes[..];
    let opacity = number(attributes, "opacity", 1.0);
    let paint = |name: &str| {
        let found = attribute(attributes, name).filter(|value| *value != "none");
        found.map(|value| colour(value).gamma_multiply(opacity))
    };
    let stroke = egui::Stroke {
        width: number(attributes, "stroke-width", 1.0),
        color: paint("stroke").unwrap_or(Color32::TRANSPARENT),
    };
    let fill = paint("fill").unwrap_or(Color32::TRANSPARENT);
    let spot = |(x, y): Spot| pos2(x as f32, y as f32);
    match &mark.form {
        Form::Line(spots) => {
            painter.add(Shape::Path(PathShape {
                points: spots.iter().copied().map(spot).collect(),
                closed: false,
                fill,
                stroke: PathStroke::from(stroke),
            }));
        }
        Form::Rectangle(corner, width, height) => {
            let rectangle = Rect::from_min_size(spot(*corner), vec2(*width as f32, *height as f32));
            painter.rect(rectangle, 0.0, fill, stroke, egui::StrokeKind::Middle);
        }
        Form::Circle(middle, radius) => {
            painter.circle(spot(*middle), *radius as f32, fill, stroke);
        }
        Form::Text(place, anchor, text) => {
            let size = number(attributes, "font-size", TEXT);
            let font = FontId::proportional(size);
            let align = match anchor {
                Anchor::Start => Align2::LEFT_TOP,
                Anchor::Middle => Align2::CENTER_TOP,
                Anchor::End => Align2::RIGHT_TOP,
            };
            // SVG places text by its baseline.
            let galley = painter.layout_no_wrap(text.clone(), font.clone(), fill);
            let line = galley.rows.first().and_then(|row| row.glyphs.first());
            let line = line.map_or(0.8 * size, |glyph| glyph.pos.y);
            let top = spot(*place) - vec2(0.0, line);
            // The font has one weight: bold is drawn twice, half a pixel apart.
            let bold = attribute(attributes, "font-weight") == Some("bold");
            for right in [0.0, 0.5].into_iter().take(1 + usize::from(bold)) {
                painter.text(top + vec2(right, 0.0), align, text, font.clone(), fill);
            }
        }
    }
}

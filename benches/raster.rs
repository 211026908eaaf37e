//! The time that painting a window takes, on one core: 1200×800 pixels, 20
//! widgets with text, and lines.

use std::f32::consts::TAU;
use std::hint::black_box;
use std::sync::Arc;

use criterion::{Criterion, criterion_group, criterion_main};
use egui::{ClippedPrimitive, Color32, Rect, TexturesDelta, pos2, vec2};

use vides_raster::{Line, Lines, Raster, Target, primitives};

const WIDTH: u32 = 1200;
const HEIGHT: u32 = 800;

/// Where the scene is painted.
fn scene() -> Rect {
    Rect::from_min_max(pos2(320.0, 10.0), pos2(1190.0, 790.0))
}

/// A circle's worth of pieces, turned by an angle.
fn curve(count: usize, angle: f32) -> Arc<Lines> {
    let middle = scene().center();
    let at = |i: usize| {
        let t = i as f32 / count as f32 * TAU;
        let r = 250.0 + 90.0 * (7.0 * t + angle).sin();
        middle + r * vec2((t + angle).cos(), (t - angle).sin())
    };
    let lines = (0..count).map(|i| Line {
        from: at(i),
        to: at(i + 1),
        width: 1.5,
        color: Color32::from_rgb(230, 180, 80),
    });
    Arc::new(Lines {
        lines: lines.collect(),
    })
}

/// Pieces of about 8 pixels all over the scene.
fn heap(count: usize, shift: f32) -> Vec<Line> {
    let rect = scene();
    let part = |i: usize, step: f32| (i as f32 * step).fract();
    (0..count)
        .map(|i| {
            let from = rect.min + rect.size() * vec2(part(i, 0.618_034), part(i, 0.754_877));
            let angle = i as f32 + shift;
            Line {
                from,
                to: from + 8.0 * vec2(angle.cos(), angle.sin()),
                width: 1.5,
                color: Color32::from_rgb(90, 200, 160),
            }
        })
        .collect()
}

/// A window's contents.
struct Window {
    context: egui::Context,
    textures: TexturesDelta,
}

impl Window {
    fn new() -> Self {
        Self {
            context: egui::Context::default(),
            textures: TexturesDelta::default(),
        }
    }

    fn run(&mut self, lines: &[Arc<Lines>], pointer: egui::Pos2) -> egui::FullOutput {
        let screen = vec2(WIDTH as f32, HEIGHT as f32);
        let input = egui::RawInput {
            screen_rect: Some(Rect::from_min_size(pos2(0.0, 0.0), screen)),
            events: vec![egui::Event::PointerMoved(pointer)],
            ..Default::default()
        };
        let mut output = self.context.run_ui(input, |ui| {
            egui::Panel::left("left")
                .default_size(300.0)
                .show(ui, |ui| {
                    ui.heading("Position and curve");
                    let mut number = 0.5;
                    for i in 0..10 {
                        ui.horizontal(|ui| {
                            let _ = ui.button(format!("Button {i}"));
                            ui.add(egui::Slider::new(&mut number, 0.0..=1.0).text("value"));
                        });
                    }
                    for i in 0..8 {
                        ui.label(format!("x {i}.123  y 4.567  z 8.901  and some more text"));
                    }
                });
            egui::CentralPanel::default().show(ui, |ui| {
                for lines in lines {
                    ui.painter().add(Lines::shape(lines, scene()));
                }
            });
        });
        self.textures
            .append(std::mem::take(&mut output.textures_delta));
        output
    }

    fn primitives(&mut self, lines: &[Arc<Lines>], pointer: egui::Pos2) -> Vec<ClippedPrimitive> {
        let output = self.run(lines, pointer);
        primitives(&self.context, output.shapes, 1.0)
    }
}

struct Screen {
    raster: Raster,
    pixels: Vec<u32>,
}

impl Screen {
    fn new(window: &mut Window) -> Self {
        let mut raster = Raster::new(Color32::BLACK);
        raster.update_textures(std::mem::take(&mut window.textures));
        Self {
            raster,
            pixels: vec![0; (WIDTH * HEIGHT) as usize],
        }
    }

    fn paint(&mut self, primitives: &[ClippedPrimitive]) -> usize {
        let mut target = Target {
            pixels: &mut self.pixels,
            stride: WIDTH as usize,
            width: WIDTH,
            height: HEIGHT,
        };
        let areas = self.raster.paint(primitives, 1.0, &mut target);
        areas
            .iter()
            .map(|a| a.width as usize * a.height as usize)
            .sum()
    }
}

/// Paints pictures by turns, so that each call has something to do.
fn by_turns(criterion: &mut Criterion, name: &str, pictures: &[Vec<Arc<Lines>>]) {
    let mut window = Window::new();
    let away = pos2(700.0, 400.0);
    // The first passes of egui are for finding sizes.
    for _ in 0..3 {
        window.primitives(&pictures[0], away);
    }
    let pictures: Vec<_> = pictures
        .iter()
        .map(|lines| window.primitives(lines, away))
        .collect();
    let mut screen = Screen::new(&mut window);
    let mut turn = 0;
    criterion.bench_function(name, |bencher| {
        bencher.iter(|| {
            turn = (turn + 1) % pictures.len();
            black_box(screen.paint(&pictures[turn]))
        });
    });
}

fn all(criterion: &mut Criterion) {
    let mut window = Window::new();
    let away = pos2(700.0, 400.0);
    let lines = [curve(2000, 0.0)];
    for _ in 0..3 {
        window.primitives(&lines, away);
    }
    let primitives = window.primitives(&lines, away);
    let mut screen = Screen::new(&mut window);
    criterion.bench_function("whole window", |bencher| {
        bencher.iter(|| {
            screen.raster.forget();
            black_box(screen.paint(&primitives))
        });
    });
    criterion.bench_function("nothing changed", |bencher| {
        bencher.iter(|| black_box(screen.paint(&primitives)));
    });
    let hovering: Vec<_> = [away, pos2(30.0, 60.0)]
        .iter()
        .map(|&pointer| {
            window.primitives(&lines, pointer);
            window.primitives(&lines, pointer)
        })
        .collect();
    screen
        .raster
        .update_textures(std::mem::take(&mut window.textures));
    let mut turn = 0;
    criterion.bench_function("a button lights up", |bencher| {
        bencher.iter(|| {
            turn = 1 - turn;
            black_box(screen.paint(&hovering[turn]))
        });
    });
    by_turns(
        criterion,
        "a curve of 2,000 lines turns",
        &[vec![curve(2000, 0.0)], vec![curve(2000, 0.1)]],
    );
    let all = Arc::new(Lines {
        lines: heap(40_000, 0.0),
    });
    let few = |shift| {
        let lines = heap(20, shift);
        Arc::new(Lines { lines })
    };
    by_turns(
        criterion,
        "40,000 lines, 20 others change",
        &[
            vec![Arc::clone(&all), few(0.5)],
            vec![Arc::clone(&all), few(1.0)],
        ],
    );
    let mut other = Lines::clone(&all);
    for line in other.lines.iter_mut().step_by(2000) {
        line.to += vec2(1.0, 1.0);
    }
    by_turns(
        criterion,
        "40,000 lines, 20 of them change",
        &[vec![Arc::clone(&all)], vec![Arc::new(other)]],
    );
    let other = Arc::new(Lines {
        lines: heap(40_000, 0.5),
    });
    by_turns(
        criterion,
        "40,000 lines, all change",
        &[vec![all], vec![other]],
    );
}

criterion_group!(benches, all);
criterion_main!(benches);

//! What is painted in small windows, as it is painted: no text is cut by its clip rectangle or
//! lies below what is painted later, and what one works with is large enough.

use egui::{Pos2, Rect, Shape};

use super::*;
use crate::action::{Action, ToolAction};
use crate::screenshots::screenshot;
use crate::space::camera_view;

/// Points and scale: 1400 × 900 pixels at twice the size, the smallest window, 800 × 600.
const SIZES: [([f32; 2], f32); 3] = [
    ([700.0, 450.0], 2.0),
    (SMALLEST, 2.0),
    ([800.0, 600.0], 1.0),
];

/// As `vides-window` tells the window manager.
const SMALLEST: [f32; 2] = [640.0, 440.0];

/// Height of the bar with menus and output field; width of the panels, which scroll.
const BAR: f32 = 32.0;
const PANELS: f32 = 262.0;

/// All windows of these sizes in both languages, with the path of the first steps, and their name.
fn windows() -> impl Iterator<Item = (Window, String)> {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/pyramid.vid");
    let cases = SIZES
        .into_iter()
        .flat_map(|size| BOTH.map(|language| (size, language)));
    cases.map(move |((size, scale), language)| {
        let options = Options {
            document: Document::load(file.as_ref()).expect("the example"),
            ..options(language)
        };
        let window = window_of(options, size, scale, Theme::Dark);
        (window, format!("{language:?}-{}", size[0]))
    })
}

/// A text that is painted, where, and what is painted over it.
struct Painted {
    text: String,
    rect: Rect,
    clip: Rect,
    over: Vec<Rect>,
}

/// All painted texts that can be seen in part.
fn painted(window: &Window) -> Vec<Painted> {
    fn add(shape: &Shape, clip: Rect, found: &mut Vec<Painted>) {
        match shape {
            Shape::Text(text) => {
                // Lines are higher than letters.
                let rect = Rect::from_min_size(Pos2::ZERO, text.galley.size());
                let rect = rect.shrink2(vec2(0.5, 0.2 * rect.height()));
                let turned = egui::emath::Rot2::from_angle(text.angle);
                let rect = rect.rotate_bb(turned).translate(text.pos.to_vec2());
                if clip.intersects(rect) && !text.galley.text().is_empty() {
                    let text = text.galley.text().to_owned();
                    let over = Vec::new();
                    found.push(Painted {
                        text,
                        rect,
                        clip,
                        over,
                    });
                }
            }
            Shape::Rect(block) if block.fill.is_opaque() => {
                let block = block.rect.intersect(clip);
                let below = found
                    .iter_mut()
                    .filter(|text| block.intersects(text.rect.intersect(text.clip)));
                below.for_each(|text| text.over.push(block));
            }
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| add(shape, clip, found)),
            _ => {}
        }
    }
    let mut found = Vec::new();
    for clipped in &window.output().shapes {
        add(&clipped.shape, clipped.clip_rect, &mut found);
    }
    found
}

/// Texts that are cut, or covered in part. What the panels scroll may be cut above and below.
fn faults(window: &Window) -> Vec<String> {
    let panels = window.ctx.content_rect().right() - PANELS;
    let seen = painted(window);
    assert!(seen.len() > 20, "{}", seen.len());
    let dock = window.state().windows.dock_place();
    let list = window
        .get_by_label(window.state().texts().space.name)
        .rect()
        .left();
    let faulty = |text: &Painted| {
        let docked = dock.is_some_and(|dock| dock.intersects(text.rect));
        // So does a long list.
        let scrolls = text.rect.left() > panels || docked || text.rect.right() < list;
        let room = match scrolls {
            true => Rect::from_x_y_ranges(text.clip.x_range(), text.rect.y_range()),
            false => text.clip,
        };
        !room.contains_rect(text.rect) || !text.over.is_empty()
    };
    let faulty = seen.into_iter().filter(faulty);
    faulty
        .map(|text| {
            format!(
                "{} {:?} in {:?} under {:?}",
                text.text, text.rect, text.clip, text.over
            )
        })
        .collect()
}

/// Where a window or menu of this order lies.
fn areas(window: &Window, order: egui::Order) -> Vec<Rect> {
    window.ctx.memory(|memory| {
        let all = memory.areas().visible_layer_ids().into_iter();
        let all = all.filter(|layer| layer.order == order && layer.id != camera_view::id());
        all.filter_map(|layer| memory.area_rect(layer.id)).collect()
    })
}

#[test]
fn no_painted_text_is_cut_or_covered() {
    for (mut window, name) in windows() {
        // What the mouse does there is told in the space.
        window.hover_at(egui::pos2(80.0, 280.0));
        for point in 0..6 {
            window.state_mut().select(point, 0);
            window.run();
            let found = faults(&window);
            assert!(found.is_empty(), "{name}, point {point}: {found:#?}");
        }
        screenshot(&mut window, &format!("layout-{name}.png"));
    }
}

/// Where there is room for them: the example's names are short.
#[test]
fn points_have_their_names_beside_the_camera_view() {
    let (window, name) = windows().next().expect("a window");
    let seen = painted(&window);
    for point in [
        "start",
        "left side",
        "left corner",
        "right corner",
        "right side",
        "end",
    ] {
        let named = |text: &Painted| text.text.ends_with(&format!("  {point}"));
        assert!(seen.iter().any(named), "{name}: {point}");
    }
}

/// What matters most stays, each number with its word.
#[test]
fn the_output_field_leaves_out_the_least_important() {
    for (window, name) in windows() {
        let texts = &window.state().texts().output;
        let seen = painted(&window);
        let has = |label: &str| {
            seen.iter()
                .any(|text| text.rect.top() < BAR && text.text == label)
        };
        let order = [
            texts.position,
            texts.view,
            texts.point,
            texts.roll,
            texts.zoom,
        ];
        let shown = order.map(has);
        let wide = window.ctx.content_rect().width();
        let least = if wide < 700.0 { 1 } else { 2 };
        assert!(
            shown[..least].iter().all(|&shown| shown),
            "{name}: {shown:?}"
        );
        // Between them nothing is left out, but the view, which is the widest.
        let last = shown.iter().rposition(|&shown| shown);
        let missing = shown[..last.unwrap_or(0)]
            .iter()
            .filter(|&&shown| !shown)
            .count();
        assert!(missing <= usize::from(!shown[1]), "{name}: {shown:?}");
    }
}

#[test]
fn the_bar_of_frames_is_long_enough() {
    for (mut window, name) in windows() {
        let texts = &window.state().texts().space;
        let (bar, graph) = (texts.timeline, texts.speed_graph);
        let rail = window.get_by_role_and_label(Role::Slider, bar).rect();
        assert!(rail.width() >= 200.0, "{name}: {rail:?}");
        // The strip of the speeds is to be had everywhere.
        let strip = |window: &Window| {
            let mut all = window.query_all_by_role_and_label(Role::Canvas, graph);
            all.next().is_some()
        };
        assert!(!strip(&window), "{name}");
        let button = window.get_by_role_and_label(Role::Button, graph);
        button.click();
        window.run();
        assert!(strip(&window), "{name}");
        let found = faults(&window);
        assert!(found.is_empty(), "{name}: {found:#?}");
        screenshot(&mut window, &format!("layout-{name}-strip.png"));
    }
}

/// Sizes in points and scales from the smallest usual window to a large screen at each of its scales.
const SCREENS: [([f32; 2], f32); 6] = [
    ([800.0, 600.0], 1.0),
    ([1200.0, 800.0], 1.0),
    ([1280.0, 720.0], 3.0),
    ([1920.0, 1080.0], 2.0),
    ([1707.0, 960.0], 1.5),
    ([3840.0, 2160.0], 1.0),
];

/// All that is docked, for the example's path.
fn docked(window: &Window) -> Vec<Action> {
    let several = vides_document::tool::tools().filter(|tool| {
        use vides_document::tool::Needs;
        matches!(tool.needs(), Needs::Nothing | Needs::Output | Needs::Stroke)
    });
    let tools = several.filter(|tool| tool.defaults(&window.state().document).is_ok());
    let others = [
        Action::Check,
        Action::Colours,
        Action::Display,
        Action::SpeedCurve,
    ];
    tools
        .map(|tool| Action::Tool(ToolAction::Open(tool)))
        .chain(others)
        .collect()
}

/// The docked state of every window: it lies over nothing, nothing in it is cut or covered, and what
/// it stands in place of comes back.
#[test]
fn what_is_docked_covers_nothing() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/pyramid.vid");
    let looks = BOTH.map(|language| [(language, Theme::Dark), (language, Theme::Light)]);
    let cases = SCREENS
        .into_iter()
        .flat_map(|size| looks.as_flattened().iter().map(move |&look| (size, look)));
    let mut seen = 0;
    for ((size, scale), (language, theme)) in cases {
        let options = Options {
            document: Document::load(file.as_ref()).expect("the example"),
            ..options(language)
        };
        let mut window = window_of(options, size, scale, theme);
        let context = window.ctx.clone();
        let texts = language.texts();
        let values = |window: &Window| {
            let mut zooms = window.query_all_by_role_and_label(Role::SpinButton, texts.zoom.value);
            zooms.next().is_some()
        };
        let pane = areas(&window, egui::Order::Middle).len();
        for action in docked(&window) {
            let what = match &action {
                Action::Tool(ToolAction::Open(tool)) => tool.name.to_owned(),
                other => format!("{other:?}"),
            };
            let name = format!("{language:?}-{theme:?}-{}x{scale}-{what}", size[0]);
            let wide = action == Action::SpeedCurve;
            window.state_mut().act(action, &context);
            window.run();
            let found = areas(&window, egui::Order::Middle);
            assert_eq!(found.len(), pane + 1, "{name}: {found:?}");
            let dock = window
                .state()
                .windows
                .dock_place()
                .expect("a place")
                .shrink(0.5);
            let whole = window.ctx.content_rect();
            assert!(whole.contains_rect(dock), "{name}: {dock:?}");
            let space = window.get_by_label(texts.space.name).rect();
            let rail = window
                .get_by_role_and_label(Role::Slider, texts.space.timeline)
                .rect();
            assert!(
                !space.intersects(dock) && !rail.intersects(dock),
                "{name}: {dock:?}"
            );
            assert!(
                space.height() > 100.0 && space.width() > 300.0,
                "{name}: {space:?}"
            );
            assert_eq!(values(&window), wide, "{name}");
            let speed = &texts.speed_window;
            let paces = [speed.distance, speed.sine, speed.parabolic, speed.ten];
            for pace in paces.iter().take(if wide { 4 } else { 0 }) {
                click(&mut window, &format!("{}: {pace}", speed.pace));
                let found = faults(&window);
                assert!(found.is_empty(), "{name}, {pace}: {found:#?}");
            }
            let found = faults(&window);
            assert!(found.is_empty(), "{name}: {found:#?}");
            if size[0] <= 1200.0 {
                screenshot(&mut window, &format!("docked-{name}.png"));
            }
            press(&mut window, Modifiers::NONE, Key::Escape);
            assert!(window.state().windows.dock_place().is_none(), "{name}");
            assert!(values(&window), "{name}");
            seen += 1;
        }
    }
    assert!(seen > 500, "{seen}");
}

/// The one that was opened last is seen; the one before comes back.
#[test]
fn one_is_docked_at_a_time() {
    let mut window = window_with_points(Language::English, LARGE, 1.0, Theme::Dark);
    let shows = |window: &Window, title: &str| window.query_by_label(title).is_some();
    let texts = Language::English.texts();
    let context = window.ctx.clone();
    for action in [Action::Check, Action::Display] {
        window.state_mut().act(action, &context);
        window.run();
    }
    assert!(shows(&window, texts.display.all) && !shows(&window, texts.check.limits));
    press(&mut window, Modifiers::NONE, Key::Enter);
    assert!(!shows(&window, texts.display.all) && shows(&window, texts.check.limits));
    press(&mut window, Modifiers::NONE, Key::Enter);
    let mut values = window.query_all_by_role_and_label(Role::SpinButton, texts.zoom.value);
    assert!(
        !shows(&window, texts.check.limits) && values.next().is_some(),
        "{:?}",
        window.state().windows.front()
    );
}

/// Windows and menus leave the bar free, and their rows reach the border.
#[test]
fn windows_and_menus_leave_the_bar_free() {
    for (mut window, name) in windows() {
        let whole = window.ctx.content_rect();
        let below = Rect::from_min_max(egui::pos2(0.0, BAR), whole.max).expand(1.0);
        let context = window.ctx.clone();
        for (action, what) in [
            (Action::Curve, "curve"),
            (Action::SpeedCurve, "speed"),
            (Action::Keys, "keys"),
        ] {
            window.state_mut().act(action, &context);
            window.run();
            for rect in areas(&window, egui::Order::Middle) {
                assert!(below.contains_rect(rect), "{name}, {what}: {rect:?}");
            }
            screenshot(&mut window, &format!("layout-{name}-{what}.png"));
            press(&mut window, Modifiers::NONE, Key::Escape);
        }
        for (letter, _) in crate::menu::letters(window.state().language(), false) {
            press(&mut window, Modifiers::ALT, letter);
            // A menu begins where its title ends.
            for rect in areas(&window, egui::Order::Foreground) {
                assert!(
                    below.expand(4.0).contains_rect(rect),
                    "{name}, {letter:?}: {rect:?}"
                );
            }
            screenshot(&mut window, &format!("layout-{name}-{}.png", letter.name()));
            press(&mut window, Modifiers::NONE, Key::Escape);
        }
    }
}

/// In a small window nothing scrolls and little is left over, with an object or without; in one of the
/// usual size it is all the more so.
#[test]
fn all_panels_are_seen_at_once() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/pyramid.vid");
    for (language, size) in BOTH
        .into_iter()
        .flat_map(|one| [(one, SMALL), (one, LARGE)])
    {
        for document in [Document::new(), Document::load(file.as_ref()).unwrap()] {
            let options = Options {
                document,
                ..options(language)
            };
            let window = window_of(options, size, 1.0, Theme::Dark);
            let texts = window.state().texts();
            let last = number(&window, texts.timing.hold).rect();
            let timeline = window.get_by_label(texts.space.play).rect();
            let below = timeline.top() - last.bottom();
            assert!(below >= 8.0, "{language:?}, {size:?}: {below}");
            assert!(size == LARGE || below < 80.0, "{language:?}: {below}");
        }
    }
}

/// However small it is, nothing is asked for that cannot be.
#[test]
fn a_window_of_one_pixel_is_a_window() {
    let car = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/car.vid");
    for size in [[1.0, 1.0], [1.0, 4000.0], [4000.0, 1.0]] {
        window_with_points(Language::German, size, 1.0, Theme::Dark);
        let document = Document::load_scene(car.as_ref()).unwrap().0;
        let options = Options {
            document,
            ..options(Language::English)
        };
        let mut window = window_of(options, size, 1.0, Theme::Light);
        window.state_mut().select_nodes(vec![0, 1]);
        window.run();
    }
}

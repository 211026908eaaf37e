//! The window's contents driven as a user drives them, without a screen: by
//! the labels that a person reads, in both languages.

mod car;
mod every_size;
mod hands;
mod keyboard;
mod large;
mod layout;
mod looks;
mod manual;
mod monkey;
mod pictures;
mod processes;
mod scene_hosts;
mod scenes;
mod stumbles;
#[path = "../../../../tests/common/until.rs"]
mod waiting;
mod words;

use std::sync::{OnceLock, PoisonError, RwLock, RwLockReadGuard, RwLockWriteGuard};
use std::time::{Duration, Instant};

pub(crate) use self::manual::tip;
pub(crate) use self::processes::{started, work_folder};
pub(crate) use self::waiting::until;
pub(crate) use crate::setup::Theme;
pub(crate) use crate::texts::fill;
pub(crate) use crate::{Editor, Folders, Language, Options, Program};
pub(crate) use egui::{Key, Modifiers, Role, vec2};
pub(crate) use egui_kittest::Harness;
pub(crate) use egui_kittest::kittest::Queryable;
pub(crate) use glam::DVec3;
pub(crate) use vides_document::{At, Document, Edit};
pub(crate) use vides_engine::path::{Orientation, Pose, Target};

pub(crate) type Window = Harness<'static, Editor>;

/// Options of a window in a language.
pub(crate) fn options(language: Language) -> Options {
    Options {
        document: Document::new(),
        file: None,
        title: None,
        language: Some(language),
        host_takes_poses: true,
        fixed_speeds: false,
        folders: Folders::default(),
        program: Program::of_tests("tests"),
        host_view: crate::HostView::default(),
    }
}

/// Opens a menu by its key, which each language has its own.
pub(crate) fn open_menu(window: &mut Window, number: usize) {
    let (letter, _) = crate::menu::letters(window.state().language(), false)[number];
    press(window, Modifiers::ALT, letter);
}

/// A window of this size and scale.
pub(crate) fn window_of(options: Options, size: [f32; 2], scale: f32, theme: Theme) -> Window {
    let mut editor = Editor::new(options).expect("an editor");
    editor.setup.theme = Some(theme);
    window_of_editor(editor, size, scale)
}

/// A window of this editor, of this size and scale.
pub(crate) fn window_of_editor(editor: Editor, size: [f32; 2], scale: f32) -> Window {
    let mut prepared = false;
    let mut window = Harness::builder()
        .with_size(vec2(size[0], size[1]))
        .with_pixels_per_point(scale)
        .with_max_steps(16)
        .renderer(crate::screenshots::renderer())
        .build_ui_state(
            move |ui, editor: &mut Editor| {
                if !prepared {
                    prepared = true;
                    editor.prepare(ui.ctx());
                }
                // The harness leaves a border around what it shows.
                let whole = egui::UiBuilder::new().max_rect(ui.ctx().content_rect());
                let mut ui = ui.new_child(whole);
                ui.set_clip_rect(ui.max_rect());
                editor.show(&mut ui);
            },
            editor,
        );
    window.run();
    window
}

/// A window as it opens, in a language.
pub(crate) fn window(language: Language) -> Window {
    window_of(options(language), LARGE, 1.0, Theme::Dark)
}

/// A window with some points, of this size and look.
pub(crate) fn window_with_points(
    language: Language,
    size: [f32; 2],
    scale: f32,
    theme: Theme,
) -> Window {
    let options = Options {
        document: some_points(),
        ..options(language)
    };
    window_of(options, size, scale, theme)
}

/// Presses a key with others held.
pub(crate) fn press(window: &mut Window, modifiers: Modifiers, key: Key) {
    window.key_press_modifiers(modifiers, key);
    window.run();
}

/// Every pose of the path.
pub(crate) fn poses(editor: &Editor) -> Vec<Pose> {
    let sampler = editor.document.sampler().unwrap();
    let mut poses = vec![Pose::default(); sampler.frame_count()];
    sampler.sample(1, &mut poses).unwrap();
    poses
}

/// Clicks the button that has this name in the window's language.
pub(crate) fn click_button(
    window: &mut Window,
    name: impl Fn(&crate::texts::Texts) -> &'static str,
) {
    let name = name(window.state().texts());
    click(window, name);
}

/// Clicks what has this label.
pub(crate) fn click(window: &mut Window, label: &str) {
    window.get_by_label(label).click();
    window.run();
}

/// The functions of the program around are everybody's: whoever looks into the menu of a track
/// reads this meanwhile, whoever registers one writes it. A menu that grows is elsewhere.
static FUNCTIONS: RwLock<()> = RwLock::new(());

pub(crate) fn functions_stay() -> RwLockReadGuard<'static, ()> {
    FUNCTIONS.read().unwrap_or_else(PoisonError::into_inner)
}

pub(crate) fn functions_change() -> RwLockWriteGuard<'static, ()> {
    FUNCTIONS.write().unwrap_or_else(PoisonError::into_inner)
}

/// Milliseconds that a processor has spent on this thread, however busy the machine is; where that
/// is not told, the clock has to do.
pub(crate) fn spent() -> f64 {
    static BEGIN: OnceLock<Instant> = OnceLock::new();
    // Of a thread that runs, the system counts only every few milliseconds.
    std::thread::sleep(Duration::from_micros(1));
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = told.and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    let clock = || BEGIN.get_or_init(Instant::now).elapsed().as_secs_f64() * 1e3;
    nanoseconds.map_or_else(clock, |spent| 1e-6 * spent)
}

/// What stands in the output field: a message, or nothing but the setting.
pub(crate) fn said(window: &Window) -> Option<String> {
    let message = window.state().message.as_ref();
    message.map(|message| {
        // It is there for the eye as well.
        assert!(
            window.query_all_by_label(&message.text).next().is_some(),
            "{}",
            message.text
        );
        message.text.clone()
    })
}

/// The same without how the length of the path has changed.
pub(crate) fn said_besides_length(window: &Window) -> Option<String> {
    let texts = &window.state().texts().output;
    let says_length = |text: &str| {
        [texts.length_changed, texts.path_length_changed]
            .iter()
            .any(|change| text.starts_with(change.split('{').next().unwrap_or_default()))
    };
    let text = said(window)?;
    match text.rsplit_once(" · ") {
        Some((text, change)) if says_length(change) => Some(text.to_owned()),
        _ => Some(text).filter(|text| !says_length(text)),
    }
}

/// Types into the number of this name and presses Enter.
pub(crate) fn enter(window: &mut Window, name: &str, text: &str) {
    type_into(window, name, text);
    press(window, Modifiers::NONE, Key::Enter);
}

/// Types into the number of this name.
pub(crate) fn type_into(window: &mut Window, name: &str, text: &str) {
    number(window, name).click();
    window.run();
    window.event(egui::Event::Text(text.to_owned()));
    window.run();
}

/// The number of this name: that of the sub-window, if a panel has one too.
pub(crate) fn number<'a>(window: &'a Window, name: &'a str) -> egui_kittest::Node<'a> {
    let all = window.get_all_by_role_and_label(Role::SpinButton, name);
    all.last().expect("a number")
}

/// The value that stands in the number of this name.
pub(crate) fn value(window: &Window, name: &str) -> String {
    number(window, name).value().expect("a value")
}

/// Both languages.
pub(crate) const BOTH: [Language; 2] = [Language::German, Language::English];

/// A roomy window, and a small one.
pub(crate) const LARGE: [f32; 2] = [1200.0, 800.0];
pub(crate) const SMALL: [f32; 2] = [800.0, 600.0];

/// Looks of which pictures of sub-windows are taken: language, theme, scale, name.
pub(crate) const LOOKS: [(Language, Theme, f32, &str); 3] = [
    (Language::German, Theme::Dark, 1.0, "de-dark"),
    (Language::English, Theme::Light, 1.0, "en-light"),
    (Language::German, Theme::Light, 2.0, "de-light-2x"),
];

/// A path with some points, of which the third has three orientations.
pub(crate) fn some_points() -> Document {
    let mut document = Document::new();
    let place = |x, y, z| DVec3::new(x, y, z);
    let all = [
        place(-0.7, -0.2, 0.7),
        place(0.0, 0.1, 0.8),
        place(0.72, 0.25, 0.6),
        place(0.6, 0.3, -0.5),
        place(0.0, 0.2, -0.7),
        place(-0.7, 0.4, -0.5),
    ];
    let mut done = |edit| document.apply(edit).expect("possible");
    done(Edit::DivideSegment {
        segment: 0,
        points: 4,
    });
    for (at, position) in all.into_iter().enumerate() {
        done(Edit::set(At::Point(at), "position", position));
        let mut orientation = Orientation {
            target: Target::Absolute(DVec3::new(0.0, 0.15, 0.0)),
            ..Orientation::default()
        };
        if at == 2 {
            orientation.speeds = [20.0, 28.0, 43.0, 54.0, 60.0, 60.0, 57.0, 53.0, 50.0, 50.0];
        }
        done(Edit::SetOrientation {
            point: at,
            at: 0,
            orientation,
        });
    }
    done(Edit::set(At::Point(3), "preset", 5));
    for x in [0.3, 0.6] {
        let target = Target::Absolute(DVec3::new(x, 0.0, -0.2));
        let orientation = Some(Orientation {
            target,
            ..Orientation::default()
        });
        done(Edit::InsertOrientation {
            point: 2,
            at: 1,
            orientation,
        });
    }
    document.select(2, 0).expect("there");
    document.mark_saved();
    document
}

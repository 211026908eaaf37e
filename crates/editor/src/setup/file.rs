//! The setup file (thesis A.5): colours, what is shown, from where.
//!
//! TOML, read as strictly as `.vid` files; what is missing is as in a new window. Not read by
//! `serde`, whose English sentences on errors could not be translated.

use std::fmt::Write;
use std::path::Path;

use egui::Color32;
use toml::de::DeTable;
use vides_document::error::{Error, Malformed, Result};
use vides_document::save;
use vides_document::vid::field::{Field, Source, fields};
use vides_document::vid::read_text;

use super::{Colours, Element, Fold, MAX_SENSOR, MIN_SENSOR, Setup, Shown, Theme, View};
use crate::files::folders;
use crate::state::Editor;
use crate::texts::{Language, fill};

/// The version that is written, and the only one that is read.
const VERSION: i64 = 1;

/// Bytes of a setup file: forty times what is written. Parsing takes some hundred times as much.
const MAX_BYTES: u64 = 64 << 10;

/// The key of the sensor's height.
const SENSOR: &str = "sensor_height_mm";

/// The key of what the ruler counts.
const RULER: &str = "ruler_frames";

/// The key of the panels that are folded.
const FOLDED: &str = "folded";

/// The key of the sliders.
const SLIDERS: &str = "sliders";

/// The key of fixed times.
const FIXED_TIMES: &str = "fixed_times";

/// The key of objects as lines.
const WIREFRAME: &str = "wireframe";

const KEYS: [&str; 18] = [
    "version",
    "theme",
    "language",
    "camera_view",
    "camera_place",
    "camera_aspect",
    SENSOR,
    "safe_frame",
    "speed_graph",
    RULER,
    FOLDED,
    SLIDERS,
    FIXED_TIMES,
    WIREFRAME,
    "view",
    "shown",
    "dark",
    "light",
];
const VIEW_KEYS: [&str; 4] = ["rotation_degrees", "tilt_degrees", "size", "shift"];

/// Reads a setup. Errors of format name file, line and reason.
pub(crate) fn load(file: &Path) -> Result<Setup> {
    let text = read_text(file, MAX_BYTES)?;
    from_toml(&text).map_err(|error| error.at(file.display()))
}

/// Saves a setup atomically, and makes the folder if need be.
pub(crate) fn write(file: &Path, setup: &Setup) -> Result<()> {
    write_text(file, &to_toml(setup))
}

fn write_text(file: &Path, text: &str) -> Result<()> {
    if let Some(folder) = file
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty())
    {
        folders::make(folder).map_err(|source| Error::Io {
            place: folder.display().to_string(),
            source,
        })?;
    }
    save::save(file, text.as_bytes())
}

fn to_toml(setup: &Setup) -> String {
    let mut out = String::with_capacity(2048);
    // Writing to a string cannot fail.
    let _ = write_setup(&mut out, setup);
    out
}

const fn theme_word(theme: Option<Theme>) -> &'static str {
    match theme {
        None => "system",
        Some(Theme::Dark) => "dark",
        Some(Theme::Light) => "light",
    }
}

const fn language_word(language: Option<Language>) -> &'static str {
    match language {
        None => "system",
        Some(Language::English) => "en",
        Some(Language::German) => "de",
    }
}

/// The names of what is folded.
fn folded_words(setup: &Setup) -> String {
    let folds = Fold::ALL.into_iter().zip(setup.folded);
    let names = folds.filter_map(|(fold, folded)| folded.then_some(fold.name()));
    format!("{:?}", names.collect::<Vec<_>>())
}

/// A setup file's text with another value for a top-level key, all else as it was.
fn with_value(text: &str, key: &str, new: &str) -> Result<String> {
    // A file that is not understood is not touched.
    from_toml(text)?;
    let source = Source { text, start: 0 };
    let root = DeTable::parse(text).map_err(|error| source.not_toml(&error))?;
    let known = root
        .get_ref()
        .iter()
        .find(|(name, _)| name.get_ref() == key);
    Ok(match known {
        Some((_, value)) => {
            let place = value.span();
            format!("{}{new}{}", &text[..place.start], &text[place.end..])
        }
        None => format!("{key} = {new}\n{text}"),
    })
}

fn write_setup(out: &mut String, setup: &Setup) -> std::fmt::Result {
    writeln!(out, "version = {VERSION}")?;
    writeln!(out, "theme = \"{}\"", theme_word(setup.theme))?;
    writeln!(out, "language = \"{}\"", language_word(setup.language))?;
    writeln!(out, "camera_view = {}", setup.camera_view)?;
    writeln!(out, "camera_place = \"{}\"", setup.camera_place.name())?;
    writeln!(out, "camera_aspect = \"{}\"", setup.camera_aspect.name())?;
    writeln!(out, "{SENSOR} = {:?}", setup.sensor_height)?;
    writeln!(out, "safe_frame = {}", setup.safe_frame)?;
    writeln!(out, "speed_graph = {}", setup.speed_graph)?;
    writeln!(out, "{RULER} = {}", setup.ruler_frames)?;
    writeln!(out, "{WIREFRAME} = {}", setup.wireframe)?;
    writeln!(out, "{FOLDED} = {}", folded_words(setup))?;
    if let Some(sliders) = setup.sliders {
        writeln!(out, "{SLIDERS} = {sliders}")?;
    }
    if let Some(fixed) = setup.fixed_times {
        writeln!(out, "{FIXED_TIMES} = {fixed}")?;
    }
    let view = &setup.view;
    writeln!(out, "\n[view]")?;
    writeln!(out, "rotation_degrees = {:?}", view.rotation)?;
    writeln!(out, "tilt_degrees = {:?}", view.tilt)?;
    writeln!(out, "size = {:?}", view.size)?;
    writeln!(out, "shift = [{:?}, {:?}]", view.shift[0], view.shift[1])?;
    writeln!(out, "\n[shown]")?;
    for element in Element::ALL.into_iter().filter(|e| e.has_switch()) {
        writeln!(out, "{} = {}", element.name(), setup.shown.has(element))?;
    }
    for (name, colours) in [("dark", &setup.dark), ("light", &setup.light)] {
        writeln!(out, "\n[{name}]")?;
        for element in Element::ALL {
            let [r, g, b, _] = colours.of(element).to_array();
            writeln!(out, "{} = \"#{r:02x}{g:02x}{b:02x}\"", element.name())?;
        }
    }
    Ok(())
}

fn from_toml(text: &str) -> Result<Setup> {
    let source = Source { text, start: 0 };
    let root = DeTable::parse(text).map_err(|error| source.not_toml(&error))?;
    let root = &root.into_inner().into();
    // First of all: what a newer version means by its keys is not known here.
    for field in fields(source, root).filter(|field| field.key == "version") {
        let version = field.integer()?;
        if version != VERSION {
            return Err(field.error(Malformed::SetupVersion {
                version,
                known: VERSION,
            }));
        }
    }
    let mut setup = Setup::default();
    for field in fields(source, root) {
        match field.key {
            "version" => {}
            "theme" => {
                setup.theme = match field.text()? {
                    "system" => None,
                    "dark" => Some(Theme::Dark),
                    "light" => Some(Theme::Light),
                    _ => {
                        return Err(field.error(Malformed::OneOf(&["system", "dark", "light"])));
                    }
                }
            }
            "language" => {
                setup.language = match field.text()? {
                    "system" => None,
                    "en" => Some(Language::English),
                    "de" => Some(Language::German),
                    _ => return Err(field.error(Malformed::OneOf(&["system", "en", "de"]))),
                }
            }
            "camera_view" => setup.camera_view = field.boolean()?,
            "camera_place" => setup.camera_place = field.choice()?,
            "camera_aspect" => setup.camera_aspect = field.choice()?,
            SENSOR => {
                setup.sensor_height = field.number()?;
                if !(MIN_SENSOR..=MAX_SENSOR).contains(&setup.sensor_height) {
                    let (low, high) = (MIN_SENSOR as i64, MAX_SENSOR as i64);
                    return Err(field.error(Malformed::Between { low, high }));
                }
            }
            "safe_frame" => setup.safe_frame = field.boolean()?,
            "speed_graph" => setup.speed_graph = field.boolean()?,
            SLIDERS => setup.sliders = Some(field.boolean()?),
            FIXED_TIMES => setup.fixed_times = Some(field.boolean()?),
            RULER => setup.ruler_frames = field.boolean()?,
            WIREFRAME => setup.wireframe = field.boolean()?,
            FOLDED => {
                for name in field.elements()? {
                    setup.folded[name.choice::<Fold>()? as usize] = true;
                }
            }
            "view" => setup.view = view(field)?,
            "shown" => read_shown(field, &mut setup.shown)?,
            "dark" => read_colours(field, &mut setup.dark)?,
            "light" => read_colours(field, &mut setup.light)?,
            _ => return Err(field.unknown(&KEYS)),
        }
    }
    Ok(setup)
}

fn view(table: Field<'_>) -> Result<View> {
    let mut view = View::default();
    for field in table.fields()? {
        match field.key {
            "rotation_degrees" => view.rotation = field.number()?,
            "tilt_degrees" => view.tilt = field.number()?,
            "size" => view.size = field.number()?,
            "shift" => view.shift = field.numbers()?,
            _ => return Err(field.unknown(&VIEW_KEYS)),
        }
        // A number written by hand may be anything: reported here, with its line.
        let mended = view.in_range();
        let rotation_only = View {
            rotation: mended.rotation,
            ..view
        };
        if mended != rotation_only {
            return Err(field.error(Malformed::View {
                least: View::MIN_SIZE,
                most: View::MAX_SIZE,
            }));
        }
    }
    Ok(view.in_range())
}

fn element(field: &Field<'_>, known: impl Fn(Element) -> bool) -> Result<Element> {
    let mut all = Element::ALL.into_iter().filter(|&element| known(element));
    match all.find(|element| element.name() == field.key) {
        Some(element) => Ok(element),
        None => {
            let all = Element::ALL.into_iter().filter(|&element| known(element));
            Err(field.unknown(&all.map(Element::name).collect::<Vec<_>>()))
        }
    }
}

fn read_shown(table: Field<'_>, shown: &mut Shown) -> Result<()> {
    for field in table.fields()? {
        shown.set(element(&field, Element::has_switch)?, field.boolean()?);
    }
    Ok(())
}

fn read_colours(table: Field<'_>, colours: &mut Colours) -> Result<()> {
    for field in table.fields()? {
        let element = element(&field, |_| true)?;
        let colour = colour(field.text()?).ok_or_else(|| field.error(Malformed::Colour))?;
        colours.set(element, colour);
    }
    Ok(())
}

/// `#rrggbb`.
fn colour(text: &str) -> Option<Color32> {
    let digits = text.strip_prefix('#')?;
    let six = digits.len() == 6 && digits.bytes().all(|byte| byte.is_ascii_hexdigit());
    let [_, r, g, b] = u32::from_str_radix(digits, 16).ok()?.to_be_bytes();
    six.then(|| Color32::from_rgb(r, g, b))
}

impl Editor {
    /// Reads the setup that a window begins with; a missing file is no error.
    pub(crate) fn read_first_setup(&mut self) {
        let Some(file) = self.folders.setup_file() else {
            return;
        };
        match load(&file) {
            Ok(setup) => self.take_setup(setup),
            Err(Error::Io { source, .. }) if source.kind() == std::io::ErrorKind::NotFound => {}
            Err(error) => self.complain(self.refused(self.texts().setup.ignored, &file, &error)),
        }
    }

    /// Sets light, dark or the desktop's theme, also for the next start.
    pub(crate) fn choose_theme(&mut self, theme: Option<Theme>) {
        self.setup.theme = theme;
        self.keep("theme", &format!("\"{}\"", theme_word(theme)));
    }

    /// Sets the language, also for the next start.
    pub(crate) fn choose_language(&mut self, language: Option<Language>) {
        self.setup.language = language;
        self.keep("language", &format!("\"{}\"", language_word(language)));
    }

    /// Sets the height in mm of the sensor for which the zoom panel tells the lens, also for the
    /// next start.
    pub(crate) fn choose_sensor(&mut self, height: f64) {
        self.setup.sensor_height = height;
        self.keep(SENSOR, &format!("{height:?}"));
    }

    /// Shows the sliders around the space, or hides them, also for the next start.
    pub(crate) fn switch_sliders(&mut self) {
        let sliders = !self.shows_sliders();
        self.setup.sliders = Some(sliders);
        self.keep(SLIDERS, &sliders.to_string());
    }

    /// Keeps the times of keys in later edits or lets them follow the speed, also for the next start.
    pub(crate) fn switch_fixed_times(&mut self) {
        let fixed = !self.times_are_fixed();
        self.setup.fixed_times = Some(fixed);
        self.keep(FIXED_TIMES, &fixed.to_string());
    }

    /// Shows objects as lines or shaded, also for the next start.
    pub(crate) fn switch_wireframe(&mut self) {
        self.setup.wireframe = !self.setup.wireframe;
        self.keep(WIREFRAME, &self.setup.wireframe.to_string());
    }

    /// Lets the ruler count frames or seconds, also for the next start.
    pub(crate) fn choose_ruler(&mut self, frames: bool) {
        self.setup.ruler_frames = frames;
        self.keep(RULER, &frames.to_string());
    }

    /// Folds a panel or unfolds it, also for the next start.
    pub(crate) fn switch_fold(&mut self, fold: Fold) {
        let folded = &mut self.setup.folded[fold as usize];
        *folded = !*folded;
        self.keep(FOLDED, &folded_words(&self.setup));
    }

    /// Puts one value into the setup file that is read at start. Anything else that is set up in
    /// this window is kept only when the user saves the setup.
    fn keep(&mut self, key: &str, value: &str) {
        let Some(file) = self.folders.setup_file() else {
            return;
        };
        let text = match read_text(&file, MAX_BYTES) {
            Err(Error::Io { source, .. }) if source.kind() == std::io::ErrorKind::NotFound => {
                Ok(format!("version = {VERSION}\n"))
            }
            read => read,
        };
        let kept = text.and_then(|old| {
            let new = with_value(&old, key, value)?;
            if new == old {
                return Ok(());
            }
            write_text(&file, &new)
        });
        if let Err(error) = kept {
            self.complain(self.refused(self.texts().setup.not_saved, &file, &error));
        }
    }

    /// What could not be done with a setup file, and why.
    fn refused(&self, text: &str, file: &Path, error: &Error) -> String {
        fill(text, &[&file.display(), &self.without_name(error)])
    }

    /// Keeps the desktop's theme.
    fn take_setup(&mut self, setup: Setup) {
        self.first_view = setup.view;
        self.setup = Setup {
            desktop: self.setup.desktop,
            ..setup
        };
    }

    /// Loads a setup. The error is a sentence; the old setup then stays.
    pub(crate) fn load_setup(&mut self, file: &Path) -> Result<(), String> {
        let texts = &self.texts().setup;
        let setup = load(file).map_err(|error| self.refused(texts.not_loaded, file, &error))?;
        self.take_setup(setup);
        self.say(fill(texts.loaded, &[&file.display()]));
        Ok(())
    }

    pub(crate) fn save_setup(&mut self, file: &Path) -> Result<(), String> {
        let texts = &self.texts().setup;
        write(file, &self.setup).map_err(|error| self.refused(texts.not_saved, file, &error))?;
        self.say(fill(texts.saved, &[&file.display()]));
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::setup::{Aspect, CameraPlace};

    fn odd_setup() -> Setup {
        let mut setup = Setup {
            theme: Some(Theme::Light),
            language: Some(Language::German),
            camera_view: false,
            camera_place: CameraPlace::Beside,
            camera_aspect: Aspect::Scope,
            sensor_height: 18.66,
            safe_frame: true,
            speed_graph: false,
            ruler_frames: true,
            folded: [
                true, false, false, true, false, true, false, false, true, false, true,
            ],
            sliders: Some(true),
            fixed_times: Some(false),
            wireframe: true,
            view: View {
                rotation: -12.345_678_901_234_5,
                tilt: 1.0 / 3.0,
                size: 2.5,
                shift: [0.1, -0.2],
            },
            ..Setup::default()
        };
        for (index, element) in (0u8..).zip(Element::ALL) {
            setup
                .shown
                .set(element, index % 3 != 0 || !element.has_switch());
            let colour = Color32::from_rgb(index, 255 - index, 16 * index);
            setup.dark.set(element, colour);
            setup.light.set(element, Color32::from_rgb(index, 7, 9));
        }
        setup
    }

    #[test]
    fn what_is_saved_comes_back() {
        for setup in [Setup::default(), odd_setup()] {
            assert_eq!(from_toml(&to_toml(&setup)).unwrap(), setup);
        }
    }

    #[test]
    fn nothing_given_is_a_new_window() {
        assert_eq!(from_toml("").unwrap(), Setup::default());
        let dark = from_toml("[dark]\ncurve = \"#010203\"\n").unwrap();
        assert_eq!(dark.dark.of(Element::Curve), Color32::from_rgb(1, 2, 3));
        assert_eq!(dark.dark.of(Element::Cube), Colours::DARK.of(Element::Cube));
        // Turned further than once round is still a rotation.
        let turned = from_toml("[view]\nrotation_degrees = 270").unwrap();
        assert_eq!(turned.view.rotation, -90.0);
    }

    #[test]
    fn what_is_wrong_is_refused_with_its_line() {
        for (text, line, word) in [
            ("version = 2", 1, "version 2"),
            ("theme = \"dark\"\ncolor = 1", 2, "unknown key \"color\""),
            ("theme = \"grey\"", 1, "\"dark\" or \"light\""),
            ("language = \"fr\"", 1, "\"en\" or \"de\""),
            ("\n[shown]\ncube = 1", 3, "true or false"),
            ("[shown]\nbackground = false", 2, "unknown key"),
            ("[dark]\ncurve = \"red\"", 2, "six digits"),
            ("[dark]\ncurve = \"#+12345\"", 2, "six digits"),
            ("[dark]\ncurve = \"#äöü\"", 2, "six digits"),
            ("[light]\nkurve = \"#000000\"", 2, "unknown key \"kurve\""),
            ("sensor_height_mm = 0.5", 1, "must lie between 1 and 500"),
            ("[view]\ntilt_degrees = 91", 2, "out of range"),
            ("[view]\nsize = nan", 2, "finite"),
            ("[view]\nsize = 0", 2, "out of range"),
            ("[view]\nshift = [1]", 2, "expected 2 numbers"),
            ("[view]\n\ntilt = 3", 3, "unknown key \"tilt\""),
            ("theme = \"dark\"\ntheme = \"dark\"", 2, ""),
            ("theme", 1, ""),
        ] {
            let error = from_toml(text).unwrap_err().to_string();
            assert!(error.contains(&format!("line {line}:")), "{text}: {error}");
            assert!(error.contains(word), "{text}: {error}");
        }
    }

    #[test]
    fn a_folder_is_made_and_a_broken_file_left_alone() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("a/b/setup.toml");
        write(&file, &odd_setup()).unwrap();
        assert_eq!(load(&file).unwrap(), odd_setup());
        std::fs::write(&file, b"\n\xff").unwrap();
        let error = load(&file).unwrap_err().to_string();
        assert!(error.contains("setup.toml: line 2:"), "{error}");
    }
}

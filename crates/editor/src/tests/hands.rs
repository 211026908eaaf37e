//! A person at the window of a scene.

use std::path::Path;

use egui::{Pos2, pos2};
use egui_kittest::kittest::NodeT;
use vides_engine::scene::{Channel, Scene};

use super::*;
use crate::space::tests::{motion, press as press_at, release};

/// A person at the window, who counts what they do: a click, a name or number typed, a key.
pub(super) struct Hands {
    pub(super) window: Window,
    pub(super) actions: u32,
}

impl Hands {
    pub(super) fn new(options: Options) -> Self {
        // So high that nothing has to be scrolled.
        Self {
            window: window_of(options, [1600.0, 1400.0], 1.0, Theme::Dark),
            actions: 0,
        }
    }

    pub(super) fn did(&mut self) {
        self.actions += 1;
        self.window.run();
    }

    pub(super) fn click(&mut self, label: &str) {
        let all = self.window.get_all_by_label(label);
        all.last().unwrap().click();
        self.did();
    }

    pub(super) fn key(&mut self, modifiers: Modifiers, key: Key) {
        press(&mut self.window, modifiers, key);
        self.did();
    }

    pub(super) fn click_at(&mut self, at: Pos2, button: egui::PointerButton) {
        press_at(&mut self.window, at, button);
        release(&mut self.window, at, button);
        self.did();
        // Two of them are no double click.
        for _ in 0..40 {
            self.window.step();
        }
    }

    /// Types a number and presses Enter.
    pub(super) fn number(&mut self, name: &str, text: &str) {
        enter(&mut self.window, name, text);
        self.did();
    }

    pub(super) fn numbers(&mut self, name: &str, parts: [&str; 3], values: [&str; 3]) {
        for (part, value) in parts.iter().zip(values) {
            let name = format!("{name} {part}");
            if super::value(&self.window, &name) != value {
                self.number(&name, value);
            }
        }
    }

    pub(super) fn place(&mut self, values: [&str; 3]) {
        self.numbers("Position", ["x", "y", "z"], values);
    }

    pub(super) fn frame(&mut self, frame: u32) {
        let name = self.window.state().texts().space.frame_number;
        self.number(name, &frame.to_string());
    }

    pub(super) fn diamond(&mut self, name: &str) {
        let label = fill(Language::English.texts().node.key_of, &[&name]);
        self.window
            .get_by_role_and_label(Role::CheckBox, &label)
            .click();
        self.did();
    }

    pub(super) fn choose(&mut self, name: &str, entry: &str) {
        self.window
            .get_by_role_and_label(Role::ComboBox, name)
            .click();
        self.did();
        let all = self.window.get_all_by_role_and_label(Role::Button, entry);
        all.last().unwrap().click();
        self.did();
    }

    /// Chooses in a menu of the bar.
    pub(super) fn entry(&mut self, menu: usize, entry: &str) {
        open_menu(&mut self.window, menu);
        self.did();
        let all = self.window.get_all_by_label_contains(entry);
        all.last().unwrap().click();
        self.did();
    }

    pub(super) fn add(&mut self, entry: &str) {
        self.entry(1, entry);
    }

    pub(super) fn scene(&self) -> Scene {
        self.window.state().document().scene().unwrap()
    }

    pub(super) fn select(&mut self, name: &str) {
        let rows = self.window.query_all_by_role(Role::ListItem);
        let called = |label: String| label.rsplit_once(' ').is_some_and(|(of, _)| of == name);
        let mut rows = rows.filter(|row| row.accesskit_node().label().is_some_and(called));
        let at = rows.next().expect("a row").rect().center();
        drop(rows);
        self.click_at(at, egui::PointerButton::Primary);
    }

    pub(super) fn rename(&mut self, name: &str) {
        let node = self.window.state().selected_nodes()[0];
        let old = self.scene().nodes()[node].name.clone();
        self.select(&old);
        self.key(Modifiers::NONE, Key::F2);
        self.key(Modifiers::COMMAND, Key::A);
        self.window.event(egui::Event::Text(name.to_owned()));
        self.did();
        self.key(Modifiers::NONE, Key::Enter);
        assert!(
            self.scene().find(name).is_some(),
            "{:?}",
            said(&self.window)
        );
    }

    pub(super) fn object(&mut self, folder: &Path, file: &str) {
        self.add(Language::English.texts().menu.add_object);
        self.file(&folder.join(file));
    }

    /// Names a file in the window that asks for one.
    pub(super) fn file(&mut self, file: &Path) {
        press(&mut self.window, Modifiers::COMMAND, Key::A);
        let label = self.window.state().texts().files.name;
        let file = file.display().to_string();
        self.window.get_by_label(label).type_text(&file);
        self.did();
        self.key(Modifiers::NONE, Key::Enter);
    }

    /// Where a track of the selected node is, at this part of the rows' width.
    pub(super) fn row(&self, channel: &Channel, along: f32) -> Pos2 {
        let node = self.window.state().selected_nodes()[0];
        let scene = self.scene();
        let tracks = scene.nodes()[node].keys().tracks();
        let row = tracks.iter().position(|track| track.channel() == channel);
        let name = self.window.state().texts().timeline.tracks;
        let rows = self.window.get_by_role_and_label(Role::Canvas, name).rect();
        let down = 20.0 * (row.unwrap() as f32 + 1.5);
        pos2(rows.left() + along * rows.width(), rows.top() + down)
    }

    /// Chooses in the menu of a track of the selected node.
    pub(super) fn track(&mut self, channel: &Channel, entries: &[&str]) {
        let _stay = functions_stay();
        let at = self.row(channel, 0.5);
        self.click_at(at, egui::PointerButton::Secondary);
        for entry in entries {
            self.click(entry);
        }
    }

    /// Takes the key at the playhead and types another time for it.
    pub(super) fn key_to(&mut self, channel: &Channel, frame: &str) {
        let texts = &self.window.state().texts().space;
        let rail = self.window.get_by_label(texts.timeline).rect().shrink(8.0);
        let last: f32 = value(&self.window, texts.last_frame).parse().unwrap();
        let gone = (self.window.state().position_on_bar() as f32 - 1.0) / (last - 1.0);
        let y = self.row(channel, 0.0).y;
        let at = pos2(rail.left() + gone * rail.width(), y);
        press_at(&mut self.window, at, egui::PointerButton::Primary);
        for along in [5.0, 9.0] {
            motion(&mut self.window, at + vec2(along, 0.0));
        }
        // With Shift between two frames.
        let hold = egui::Event::ModifiersChanged;
        self.window.event(hold(Modifiers::SHIFT));
        self.window.event(egui::Event::Text(frame.to_owned()));
        self.did();
        release(
            &mut self.window,
            at + vec2(9.0, 0.0),
            egui::PointerButton::Primary,
        );
        self.window.event(hold(Modifiers::NONE));
        self.did();
    }
}

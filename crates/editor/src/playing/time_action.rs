//! What is done on the timeline.

use crate::action::TimeAction;
use crate::state::Editor;

impl Editor {
    pub(crate) fn time_action(&mut self, action: TimeAction, context: &egui::Context) {
        match action {
            TimeAction::Plot(quantity) => self.plot(quantity),
            TimeAction::SwitchSpeedGraph => self.switch_speed_graph(),
            TimeAction::PlayOrPause => self.play_or_pause(context),
            TimeAction::Playhead(entry) => self.enter_frame(entry),
            TimeAction::Rate(fps) => self.set_rate(fps),
            TimeAction::SwitchLoops => self.switch_loops(context),
            TimeAction::SwitchOnlySelected => self.switch_only_selected(context),
            TimeAction::SwitchFixedTimes => self.switch_fixed_times(),
            TimeAction::SwitchMovesAlong => self.switch_moves_along(),
            // A host has changed meanwhile what was dragged: the drag has ended.
            TimeAction::Retime(_) | TimeAction::MoveKeys(_) | TimeAction::MoveMarker { .. }
                if !self.document.in_step() => {}
            TimeAction::Retime(retiming) => self.retime(retiming),
            TimeAction::MoveKeys(motion) => self.move_keys(&motion),
            TimeAction::MoveMarker { name, to } => self.move_marker(&name, to),
            TimeAction::See(seen) => self.playing.see(seen),
            TimeAction::RulerInFrames(frames) => self.choose_ruler(frames),
            TimeAction::GraphHeight(height) => self.set_graph_height(height),
            TimeAction::Pace(pace) => self.set_pace(pace, context),
        }
    }
}

//! A child window for the host, which draws in it or embeds another window in it.
//!
//! We select only events about the pane's children: only one client can select ButtonPress and
//! SubstructureRedirect, which is the host. Editor widgets above the pane are cut out of its shape,
//! because a child window covers its parent.

use x11rb::protocol::Event;
use x11rb::protocol::shape::{ConnectionExt as _, SK, SO};
use x11rb::protocol::xfixes::SaveSetMode;
use x11rb::protocol::xproto::{
    ChangeWindowAttributesAux, ClipOrdering, ConfigureWindowAux, ConnectionExt as _, EventMask,
    Rectangle,
};

use super::connection::Connection;
use super::packets::SENT;
use super::state::Window;
use super::{pane_pool, window};
use crate::error::Result;
use vides_raster::Area;

/// The place of a pane, in pixels of the window.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PanePlace {
    /// The pane's rectangle.
    pub area: Area,
    /// Areas in front of the pane, which are cut out of it.
    pub above: Vec<Area>,
}

/// A pane as the host sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PaneWindow {
    /// The X window.
    pub window: u32,
    /// Its width in pixels.
    pub width: u32,
    /// Its height in pixels.
    pub height: u32,
}

pub(super) struct Pane {
    window: u32,
    place: PanePlace,
    /// Windows the host has created in it.
    children: Vec<u32>,
}

impl Window {
    /// Shows the pane at `place`, or hides it. `false` if the server cannot support panes at all.
    ///
    /// # Errors
    /// [`crate::Error::Display`] if the server or the window is gone.
    pub fn place_pane(&mut self, place: Option<&PanePlace>) -> Result<bool> {
        self.alive()?;
        let result = match (place, &mut self.pane) {
            (Some(place), Some(pane)) => pane.put(&self.connection, place).map(|()| true),
            (Some(place), None) => self.open_pane(place),
            (None, _) => self.close_pane().map(|()| true),
        };
        self.noted(result)
    }

    /// The pane shown now.
    pub fn pane(&self) -> Option<PaneWindow> {
        self.pane.as_ref().map(|pane| PaneWindow {
            window: pane.window,
            width: pane.place.area.width,
            height: pane.place.area.height,
        })
    }

    fn open_pane(&mut self, place: &PanePlace) -> Result<bool> {
        let connection = &self.connection;
        if !pane_pool::can(connection)? {
            return Ok(false);
        }
        let Ok(Some(pane)) = pane_pool::take(connection.display()) else {
            return Ok(false);
        };
        // Its parent, our window, receives an event when it is destroyed.
        let ours = self.frame.window;
        for (window, mask) in [
            (pane, EventMask::SUBSTRUCTURE_NOTIFY),
            (ours, window::events() | EventMask::SUBSTRUCTURE_NOTIFY),
        ] {
            let listen = ChangeWindowAttributesAux::new().event_mask(mask);
            connection.sent(connection.change_window_attributes(window, &listen))?;
        }
        pane_pool::save_in(connection, pane, SaveSetMode::INSERT)?;
        let [x, y] = corner(place.area);
        connection.sent(connection.reparent_window(pane, ours, x, y))?;
        let mut made = Pane {
            window: pane,
            place: PanePlace::default(),
            children: Vec::new(),
        };
        made.put(connection, place)?;
        let shown = connection.done(connection.map_window(pane))?;
        self.pane = Some(made);
        if !shown {
            self.close_pane()?;
        }
        Ok(shown)
    }

    /// Parks the pane: the host may continue to draw in it, invisibly.
    pub(super) fn close_pane(&mut self) -> Result<()> {
        let Some(pane) = self.pane.take() else {
            return Ok(());
        };
        let connection = &self.connection;
        let deaf = ChangeWindowAttributesAux::new().event_mask(EventMask::NO_EVENT);
        connection.sent(connection.change_window_attributes(pane.window, &deaf))?;
        let forgotten = pane_pool::save_in(connection, pane.window, SaveSetMode::DELETE);
        // Wait until the server has handled all requests for the pane.
        let done = forgotten.and_then(|()| connection.answer(connection.get_input_focus()));
        pane_pool::park(connection.display(), pane.window);
        done.map(drop)
    }

    /// Follows what the host does in the pane, ignoring events sent by other clients.
    pub(super) fn pane_event(&mut self, event: &Event) -> Result<()> {
        let Some(pane) = &mut self.pane else {
            return Ok(());
        };
        match event {
            Event::CreateNotify(event)
                if event.response_type & SENT == 0 && event.parent == pane.window =>
            {
                pane.adopt(&self.connection, event.window)?;
            }
            Event::ReparentNotify(event) if event.response_type & SENT == 0 => {
                if event.parent == pane.window {
                    pane.adopt(&self.connection, event.window)?;
                } else if event.event == pane.window {
                    pane.children.retain(|&child| child != event.window);
                    let display = self.connection.display();
                    pane_pool::save(display, event.window, SaveSetMode::DELETE);
                }
            }
            Event::DestroyNotify(event) if event.response_type & SENT == 0 => {
                if event.window == pane.window {
                    self.pane = None;
                    self.news.input = true;
                } else if event.event == pane.window {
                    pane.children.retain(|&child| child != event.window);
                }
            }
            _ => {}
        }
        Ok(())
    }
}

impl Pane {
    /// Moves and resizes the pane and its children. Waits until a new size has taken effect,
    /// because it is reported to the host next.
    fn put(&mut self, connection: &Connection, place: &PanePlace) -> Result<()> {
        if self.place == *place {
            return Ok(());
        }
        let (old, new) = (self.place.area, place.area);
        if old != new {
            let [x, y] = corner(new).map(i32::from);
            let area = ConfigureWindowAux::new().x(x).y(y).width(new.width);
            let area = area.height(new.height);
            connection.sent(connection.configure_window(self.window, &area))?;
        }
        let (set, bounding, any) = (SO::SET, SK::BOUNDING, ClipOrdering::UNSORTED);
        let (pane, parts) = (self.window, visible(place));
        connection.sent(connection.shape_rectangles(set, bounding, any, pane, 0, 0, &parts))?;
        self.place.clone_from(place);
        if (old.width, old.height) != (new.width, new.height) {
            for &child in &self.children {
                self.fill(connection, child)?;
            }
            connection.answer(connection.get_input_focus())?;
        }
        Ok(())
    }

    fn adopt(&mut self, connection: &Connection, child: u32) -> Result<()> {
        if !self.children.contains(&child) {
            self.children.push(child);
        }
        pane_pool::save(connection.display(), child, SaveSetMode::INSERT);
        self.fill(connection, child)
    }

    /// Makes a child fill the pane. A child that is gone causes an error event, which is ignored.
    fn fill(&self, connection: &Connection, child: u32) -> Result<()> {
        let Area { width, height, .. } = self.place.area;
        let size = ConfigureWindowAux::new().x(0).y(0);
        let asked = connection.configure_window(child, &size.width(width).height(height));
        connection.sent(asked).map(drop)
    }
}

/// An area's corner, clamped to X's coordinates.
fn corner(area: Area) -> [i16; 2] {
    [area.x, area.y].map(|at| i16::try_from(at).unwrap_or(i16::MAX))
}

fn visible(place: &PanePlace) -> Vec<Rectangle> {
    let mut parts = vec![place.area];
    for &above in &place.above {
        parts = parts
            .iter()
            .flat_map(|&part| without(part, above))
            .collect();
    }
    let short = |pixels: u32| u16::try_from(pixels).unwrap_or(u16::MAX);
    let from = |at: u32, start: u32| i16::try_from(at - start).unwrap_or(i16::MAX);
    let rectangle = |part: Area| Rectangle {
        x: from(part.x, place.area.x),
        y: from(part.y, place.area.y),
        width: short(part.width),
        height: short(part.height),
    };
    parts.into_iter().map(rectangle).collect()
}

/// The area minus another: the strips above, left, right and below.
fn without(area: Area, hole: Area) -> impl Iterator<Item = Area> {
    let (right, bottom) = (area.x + area.width, area.y + area.height);
    let end = |at: u32, length: u32| at.saturating_add(length);
    let left_edge = hole.x.clamp(area.x, right);
    let right_edge = end(hole.x, hole.width).clamp(left_edge, right);
    let top_edge = hole.y.clamp(area.y, bottom);
    let bottom_edge = end(hole.y, hole.height).clamp(top_edge, bottom);
    let parts = if left_edge == right_edge || top_edge == bottom_edge {
        [
            (area.x, area.y, right, bottom),
            (0, 0, 0, 0),
            (0, 0, 0, 0),
            (0, 0, 0, 0),
        ]
    } else {
        [
            (area.x, area.y, right, top_edge),
            (area.x, top_edge, left_edge, bottom_edge),
            (right_edge, top_edge, right, bottom_edge),
            (area.x, bottom_edge, right, bottom),
        ]
    };
    let area = |(x, y, right, bottom): (u32, u32, u32, u32)| Area {
        x,
        y,
        width: right - x,
        height: bottom - y,
    };
    parts
        .into_iter()
        .map(area)
        .filter(|part| part.width > 0 && part.height > 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_lies_above_is_cut_out() {
        let area = |x, y, width, height| Area {
            x,
            y,
            width,
            height,
        };
        let pane = area(20, 10, 30, 20);
        let holes = [
            vec![],
            vec![area(0, 0, 100, 100)],
            vec![
                area(25, 15, 5, 5),
                area(28, 0, 9, 18),
                area(45, 25, 100, 100),
            ],
            vec![area(0, 0, 20, 100), area(50, 0, 9, 9), area(30, 15, 0, 5)],
            vec![area(20, 10, 30, 1), area(0, 29, u32::MAX, u32::MAX)],
        ];
        for above in holes {
            let place = PanePlace {
                area: pane,
                above: above.clone(),
            };
            let parts = visible(&place);
            for y in 0..20 {
                for x in 0..30 {
                    let within = |x: u32, y: u32, area: &Area| {
                        (area.x..area.x.saturating_add(area.width)).contains(&x)
                            && (area.y..area.y.saturating_add(area.height)).contains(&y)
                    };
                    let free = !above.iter().any(|hole| within(20 + x, 10 + y, hole));
                    let times = parts.iter().filter(|part| {
                        let (left, top) = (part.x as u32, part.y as u32);
                        within(
                            x,
                            y,
                            &area(left, top, part.width.into(), part.height.into()),
                        )
                    });
                    assert_eq!(times.count(), usize::from(free), "({x}, {y}) {above:?}");
                }
            }
        }
    }
}

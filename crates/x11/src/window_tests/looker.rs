//! What another client sees of a window, and does to it.

use x11rb::connection::Connection as _;
use x11rb::protocol::xproto::{
    ColormapAlloc, ConfigureWindowAux, ConnectionExt as _, CreateGCAux, CreateWindowAux, EventMask,
    ImageFormat, MapState, PropMode, Rectangle, WindowClass,
};
use x11rb::rust_connection::RustConnection;
use x11rb::wrapper::ConnectionExt as _;

use super::{Shown, colour};
use crate::testing::Server;
use vides_raster::Area;

pub(super) struct Looker {
    pub(super) connection: RustConnection,
    screen: usize,
}

impl Looker {
    pub(super) fn new(server: &Server) -> Self {
        let (connection, screen) = RustConnection::connect(Some(server.display())).unwrap();
        Self { connection, screen }
    }

    /// Levels of red, green and blue at each place of the screen's image of a
    /// window, and the highest level of each.
    pub(super) fn levels(&self, window: u32, area: Area) -> (Vec<[u32; 3]>, [u32; 3]) {
        let setup = self.connection.setup();
        let image = self.connection.get_image(
            ImageFormat::Z_PIXMAP,
            window,
            area.x as i16,
            area.y as i16,
            area.width as u16,
            area.height as u16,
            u32::MAX,
        );
        let image = image.unwrap().reply().unwrap();
        let screen = &setup.roots[self.screen];
        let mut visuals = screen
            .allowed_depths
            .iter()
            .flat_map(|depth| &depth.visuals);
        let visual = visuals
            .find(|visual| visual.visual_id == image.visual)
            .unwrap();
        let mut formats = setup.pixmap_formats.iter();
        let format = formats.find(|format| format.depth == image.depth).unwrap();
        let bytes = usize::from(format.bits_per_pixel / 8);
        let pad = usize::from(format.scanline_pad / 8);
        let row = (area.width as usize * bytes).div_ceil(pad) * pad;
        let masks = [visual.red_mask, visual.green_mask, visual.blue_mask];
        let level = |pixel: u32, mask: u32| (pixel & mask) / (mask & mask.wrapping_neg());
        let mut levels = Vec::new();
        for y in 0..area.height as usize {
            for x in 0..area.width as usize {
                let start = y * row + x * bytes;
                let mut pixel = [0; 4];
                pixel[..bytes].copy_from_slice(&image.data[start..start + bytes]);
                let pixel = u32::from_le_bytes(pixel);
                levels.push(masks.map(|mask| level(pixel, mask)));
            }
        }
        (levels, masks.map(|mask| level(mask, mask)))
    }

    /// Resizes a window as a window manager would.
    pub(super) fn resize(&self, window: u32, width: u32, height: u32) {
        let size = ConfigureWindowAux::new().width(width).height(height);
        self.connection.configure_window(window, &size).unwrap();
        self.connection.flush().unwrap();
    }

    pub(super) fn root(&self) -> u32 {
        self.connection.setup().roots[self.screen].root
    }

    /// A window of the looker's own.
    pub(super) fn window(&self, parent: u32, size: (u16, u16), depth: u8) -> u32 {
        let [window, colormap] = [(), ()].map(|()| self.connection.generate_id().unwrap());
        let screen = &self.connection.setup().roots[self.screen];
        let visuals = screen.allowed_depths.iter().find(|of| of.depth == depth);
        let visual = visuals.expect("such a depth").visuals[0].visual_id;
        (self.connection)
            .create_colormap(ColormapAlloc::NONE, colormap, screen.root, visual)
            .unwrap();
        let attributes = CreateWindowAux::new().border_pixel(0).colormap(colormap);
        let kind = WindowClass::INPUT_OUTPUT;
        let (width, height) = size;
        let asked = self.connection.create_window(
            depth,
            window,
            parent,
            0,
            0,
            width,
            height,
            0,
            kind,
            visual,
            &attributes,
        );
        asked.unwrap().check().unwrap();
        self.connection.map_window(window).unwrap();
        self.sync();
        window
    }

    /// The parent of a window, and whether it is mapped; nothing if there is no such window.
    pub(super) fn place(&self, window: u32) -> Option<(u32, bool)> {
        let tree = self.connection.query_tree(window).unwrap().reply().ok()?;
        let attributes = self.connection.get_window_attributes(window).unwrap();
        let mapped = attributes.reply().ok()?.map_state != MapState::UNMAPPED;
        Some((tree.parent, mapped))
    }

    /// Where a window is in its parent, and its size.
    pub(super) fn geometry(&self, window: u32) -> [i32; 4] {
        let place = self
            .connection
            .get_geometry(window)
            .unwrap()
            .reply()
            .unwrap();
        [
            place.x.into(),
            place.y.into(),
            place.width.into(),
            place.height.into(),
        ]
    }

    /// Paints over a window's upper left corner.
    pub(super) fn spoil(&self, window: u32) {
        let context = self.connection.generate_id().unwrap();
        let colour = CreateGCAux::new().foreground(0x55aa);
        self.connection.create_gc(context, window, &colour).unwrap();
        let place = Rectangle {
            x: 50,
            y: 60,
            width: 100,
            height: 70,
        };
        self.connection
            .poly_fill_rectangle(window, context, &[place])
            .unwrap();
    }

    /// Sends a window an event, as every client can.
    pub(super) fn send(&self, window: u32, event: impl Into<[u8; 32]>) {
        let sent = self
            .connection
            .send_event(false, window, EventMask::NO_EVENT, event);
        sent.unwrap().ignore_error();
    }

    /// The server has done all that was asked of it here.
    pub(super) fn sync(&self) {
        self.connection.get_input_focus().unwrap().reply().unwrap();
    }

    pub(super) fn atom(&self, name: &str) -> u32 {
        let reply = self.connection.intern_atom(false, name.as_bytes());
        reply.unwrap().reply().unwrap().atom
    }

    pub(super) fn property(&self, window: u32, name: &str) -> Vec<u8> {
        let name = self.atom(name);
        let any = x11rb::protocol::xproto::AtomEnum::ANY;
        let reply = self
            .connection
            .get_property(false, window, name, any, 0, 1 << 20);
        reply.unwrap().reply().unwrap().value
    }

    /// Sets the desktop's resources.
    pub(super) fn resources(&self, text: &str) {
        let [name, kind] = [self.atom("RESOURCE_MANAGER"), self.atom("STRING")];
        let (root, text) = (self.root(), text.as_bytes());
        let set = self
            .connection
            .change_property8(PropMode::REPLACE, root, name, kind, text);
        set.unwrap().check().unwrap();
    }

    /// The window shows what the seed's noise is, as near as the screen can.
    pub(super) fn check(&self, shown: &Shown, seed: u32, size: (u32, u32)) {
        let area = Area {
            x: 0,
            y: 0,
            width: size.0,
            height: size.1,
        };
        let (levels, most) = self.levels(shown.id(), area);
        for (place, levels) in levels.iter().enumerate() {
            let (x, y) = (place as u32 % size.0, place as u32 / size.0);
            let [_, wanted @ ..] = colour(seed, x, y).to_be_bytes();
            for i in 0..3 {
                let true_level = f64::from(wanted[i]) / 255.0 * f64::from(most[i]);
                let off = (f64::from(levels[i]) - true_level).abs();
                let bound = if most[i] < 255 { 1.0 } else { 0.501 };
                assert!(
                    off < bound,
                    "({x}, {y}): {levels:?} of {most:?} for {wanted:?}"
                );
            }
        }
    }
}

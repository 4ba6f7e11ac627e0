//! The window: all that knows of the library that opens it.

use crate::input::{Input, Press};
use minifb::{InputCallback, Key, MouseButton, MouseMode, WindowOptions};
use std::collections::BTreeSet;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::{Duration, Instant};
use traylib_demos::Failure;
use traylib_math::{Vec2, Vec3};

/// A window of the screen, with its mouse and keyboard.
pub(crate) struct Window {
    screen: minifb::Window,
    events: Receiver<(Key, bool)>,
    /// Keys that are down, by their numbers.
    held: BTreeSet<u8>,
    /// True if they come to this window.
    is_active: bool,
    /// The last position of the mouse, and the button that was down then.
    drag: Option<(Vec2, Button)>,
    last_input: Instant,
    last_drawn: Instant,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Button {
    Left,
    Other,
}

/// Every key that goes down or up, however shortly: between two looks it may do both.
struct Keys(Sender<(Key, bool)>);

impl InputCallback for Keys {
    fn add_char(&mut self, _: u32) {}

    fn set_key_state(&mut self, key: Key, is_down: bool) {
        // The window does not live longer than its input.
        let _ = self.0.send((key, is_down));
    }
}

/// Times a second that mouse and keyboard are looked at.
const LOOKS: usize = 60;

/// The time after which a picture is drawn again that other windows may have erased.
const DRAWN_AGAIN: Duration = Duration::from_millis(200);

impl Window {
    /// Opens a window of so many columns and rows.
    ///
    /// # Errors
    /// There is no display.
    pub(crate) fn open(title: &str, (width, height): (u32, u32)) -> Result<Self, Failure> {
        let options = WindowOptions { resize: true, ..WindowOptions::default() };
        let window = minifb::Window::new(title, width as usize, height as usize, options);
        let mut screen = window.map_err(|error| {
            let error = error.to_string().replace('\n', " ");
            Failure::output(format_args!(
                "no window can be opened: {error}; without a display --frames measures speed, and the other programs write pictures"
            ))
        })?;
        screen.set_target_fps(LOOKS);
        let (sender, events) = channel();
        screen.set_input_callback(Box::new(Keys(sender)));
        let now = Instant::now();
        let (held, drag) = (BTreeSet::new(), None);
        Ok(Self { screen, events, held, is_active: false, drag, last_input: now, last_drawn: now })
    }

    /// Changes the title.
    pub(crate) fn set_title(&mut self, title: &str) {
        // It goes to a library of C.
        self.screen.set_title(&title.replace('\0', ""));
    }

    /// Shows pixels in rows of so many, stretched to the window if they are others than its
    /// own, where they are new or were long ago; then waits a moment.
    ///
    /// # Errors
    /// The display does not take them.
    pub(crate) fn show(
        &mut self,
        pixels: &[u32],
        (width, height): (u32, u32),
        is_new: bool,
    ) -> Result<(), Failure> {
        if !is_new && self.last_drawn.elapsed() < DRAWN_AGAIN {
            self.screen.update();
            return Ok(());
        }
        self.last_drawn = Instant::now();
        let drawn = self.screen.update_with_buffer(pixels, width as usize, height as usize);
        drawn.map_err(|error| Failure::output(format_args!("the window is lost: {error}")))
    }

    /// Returns the actions since the last time; `None` if the window was closed.
    pub(crate) fn input(&mut self) -> Option<Input> {
        if !self.screen.is_open() {
            return None;
        }
        let now = Instant::now();
        let seconds = (now - self.last_input).as_secs_f32();
        self.last_input = now;
        let (width, height) = self.screen.get_size();
        let pressed = self.pressed();
        let (turn, shift) = self.drawn();
        let axis = |minus, plus| self.is_held(plus) - self.is_held(minus);
        Some(Input {
            seconds,
            size: (width as u32, height as u32),
            pressed,
            walk: Vec3::new(axis(Key::A, Key::D), axis(Key::Q, Key::E), axis(Key::S, Key::W)),
            look: Vec2::new(axis(Key::Left, Key::Right), axis(Key::Down, Key::Up)),
            fast: self.is_held(Key::LeftShift) + self.is_held(Key::RightShift) > 0.0,
            turn,
            shift,
            wheel: self.screen.get_scroll_wheel().map_or(0.0, |(_, notches)| notches),
        })
    }

    /// Keys that went down, in their order.
    fn pressed(&mut self) -> Vec<Press> {
        let mut pressed = Vec::new();
        for (key, is_down) in self.events.try_iter() {
            // A key that is held says so again and again.
            if !is_down {
                self.held.remove(&(key as u8));
            } else if self.held.insert(key as u8) {
                pressed.extend(meaning(key));
            }
        }
        // Keys that are let go elsewhere are not heard. Who was never told that the window is
        // active cannot tell when it is no more.
        let was_active = std::mem::replace(&mut self.is_active, self.screen.is_active());
        if was_active && !self.is_active {
            self.held.clear();
        }
        pressed
    }

    fn is_held(&self, key: Key) -> f32 {
        f32::from(u8::from(self.held.contains(&(key as u8))))
    }

    /// Returns the distances that the mouse was dragged with its left button, and with another.
    fn drawn(&mut self) -> (Vec2, Vec2) {
        let last = self.drag.take();
        let place = self.screen.get_unscaled_mouse_pos(MouseMode::Pass).map(Vec2::from);
        let is_down = |button| self.screen.get_mouse_down(button);
        let button = if is_down(MouseButton::Left) {
            Some(Button::Left)
        } else if is_down(MouseButton::Right) || is_down(MouseButton::Middle) {
            Some(Button::Other)
        } else {
            None
        };
        self.drag = place.zip(button);
        match (last, self.drag) {
            (Some((from, Button::Left)), Some((to, Button::Left))) => (to - from, Vec2::ZERO),
            (Some((from, Button::Other)), Some((to, Button::Other))) => (Vec2::ZERO, to - from),
            _ => (Vec2::ZERO, Vec2::ZERO),
        }
    }
}

/// Returns the immediate action of a key, if it has one.
#[expect(clippy::wildcard_enum_match_arm, reason = "a keyboard has many keys")]
fn meaning(key: Key) -> Option<Press> {
    match key {
        Key::Escape => Some(Press::End),
        Key::Home => Some(Press::Home),
        Key::P => Some(Press::Print),
        Key::F12 => Some(Press::Write),
        Key::Key1 | Key::NumPad1 => Some(Press::Method(0)),
        Key::Key2 | Key::NumPad2 => Some(Press::Method(1)),
        Key::Key3 | Key::NumPad3 => Some(Press::Method(2)),
        Key::Key4 | Key::NumPad4 => Some(Press::Method(3)),
        Key::Key5 | Key::NumPad5 => Some(Press::Method(4)),
        Key::Key6 | Key::NumPad6 => Some(Press::Auto),
        _ => None,
    }
}

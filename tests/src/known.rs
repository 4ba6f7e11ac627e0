//! Scenes whose picture, or noise, is known in closed form, each with its
//! derivation.
//!
//! | scenes | where |
//! |---|---|
//! | A1 to A3, A5, A8, A9: direct light of points, disks, balls, squares; lobes | [`analytic`] |
//! | A4: a ball cut by the horizon | [`horizon`] |
//! | A6, A7: upright rectangles, polygons | [`polygonal`], by [`polygon`] |
//! | A10: tubes and cones | [`tubes`] |
//! | B1, B2, B4, B5: closed rooms of one radiance, lights in a ball | [`furnace`] |
//! | B3, B7: glossy rooms, rooms by their flux | [`rooms`] |
//! | B6: concentric balls | [`concentric`] |
//! | C1 to C4: light that a mirror throws | [`mirrored`] |
//! | E1 to E4: panes, sheets and glass | [`transmission`] |
//! | D1: the corner; what whole surfaces send one another | [`exchange`] |
//! | D2 to D11: geometry that hurts | [`hard`] |
//! | the noise of A2 | [`variance`], measured by [`estimators`] |

pub mod analytic;
pub mod concentric;
pub mod estimators;
pub mod exchange;
pub mod furnace;
pub mod hard;
pub mod horizon;
pub mod mirrored;
pub mod polygon;
pub mod polygonal;
pub mod rooms;
pub mod transmission;
pub mod tubes;
pub mod variance;

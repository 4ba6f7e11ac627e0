//! The steps of a transform, the first of which is done first.

use super::Fault;
use super::values::unreadable;
use traylib_math::glam::{DAffine3, DMat3, DVec3};

/// Moves by a vector.
pub(super) fn translate(by: [f64; 3]) -> DAffine3 {
    DAffine3::from_translation(DVec3::from(by))
}

/// Scales along the axes.
pub(super) fn scale(by: [f64; 3]) -> DAffine3 {
    DAffine3::from_scale(DVec3::from(by))
}

/// Turns about an axis, counter-clockwise seen against it, by degrees.
pub(super) fn rotate(axis: [f64; 3], degrees: f64) -> Result<DAffine3, Fault> {
    let axis = DVec3::from(axis);
    let unit = axis.try_normalize().ok_or_else(|| unreadable(&axis.to_string(), "an axis"))?;
    let (sine, cosine) = sine_and_cosine(degrees);
    let turned =
        |v: DVec3| v * cosine + unit.cross(v) * sine + unit * (unit.dot(v) * (1.0 - cosine));
    Ok(DAffine3::from_mat3(DMat3::from_cols(turned(DVec3::X), turned(DVec3::Y), turned(DVec3::Z))))
}

/// Tells whether a vector is of length one, but for rounding as people do it.
pub(super) fn is_unit(vector: [f64; 3]) -> bool {
    (DVec3::from(vector).length() - 1.0).abs() < 1e-3
}

/// Exact for right angles, so that what stood upright does so still.
fn sine_and_cosine(degrees: f64) -> (f64, f64) {
    match degrees.rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        turn => turn.to_radians().sin_cos(),
    }
}

/// A matrix of three or four rows, one after the other.
pub(super) fn matrix(numbers: &[f64], text: &str) -> Result<DAffine3, Fault> {
    let wrong = || unreadable(text, "a matrix of 16 or 9 numbers that keeps parallels");
    let row = |row: usize, width: usize| DVec3::from_slice(&numbers[row * width..]);
    match numbers {
        [.., x, y, z, w] if numbers.len() == 16 => {
            if [*x, *y, *z] != [0.0; 3] || *w == 0.0 {
                return Err(wrong());
            }
            let rows = [0, 1, 2].map(|index| row(index, 4) / *w);
            let translation = DVec3::new(numbers[3], numbers[7], numbers[11]) / *w;
            let matrix3 = DMat3::from_cols(rows[0], rows[1], rows[2]).transpose();
            Ok(DAffine3 { matrix3, translation })
        }
        [..] if numbers.len() == 9 => {
            let rows = DMat3::from_cols(row(0, 3), row(1, 3), row(2, 3));
            Ok(DAffine3::from_mat3(rows.transpose()))
        }
        _ => Err(wrong()),
    }
}

/// Takes z from `origin` to `target`, with y toward `up` and x to the left.
pub(super) fn look_at(origin: [f64; 3], target: [f64; 3], up: [f64; 3]) -> Result<DAffine3, Fault> {
    let [origin, target, up] = [origin, target, up].map(DVec3::from);
    let wrong = || unreadable("lookat", "a view: origin, target and up are in a line");
    let forward = (target - origin).try_normalize().ok_or_else(wrong)?;
    let left = up.cross(forward).try_normalize().ok_or_else(wrong)?;
    let matrix3 = DMat3::from_cols(left, forward.cross(left), forward);
    Ok(DAffine3 { matrix3, translation: origin })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarter_turns_are_exact() {
        let turn = rotate([2.0, 0.0, 0.0], 90.0).unwrap();
        assert_eq!(turn.transform_vector3(DVec3::Y), DVec3::Z);
        assert!(rotate([0.0; 3], 90.0).is_err());
    }

    #[test]
    fn rows_of_matrices_follow_each_other() {
        let wide: Vec<f64> = (1..=12).map(f64::from).chain([0.0, 0.0, 0.0, 2.0]).collect();
        let found = matrix(&wide, "").unwrap();
        assert_eq!(found.transform_point3(DVec3::X), DVec3::new(2.5, 6.5, 10.5));
        let narrow: Vec<f64> = (1..=9).map(f64::from).collect();
        assert_eq!(
            matrix(&narrow, "").unwrap().transform_vector3(DVec3::X),
            DVec3::new(1.0, 4.0, 7.0)
        );
        assert!(matrix(&[1.0; 16], "").is_err() && matrix(&[1.0; 4], "").is_err());
    }

    #[test]
    fn a_view_has_x_to_the_left() {
        let view = look_at([0.0, 0.0, 5.0], [0.0; 3], [0.0, 3.0, 0.0]).unwrap();
        let to = |v| view.transform_vector3(v);
        assert_eq!(
            [to(DVec3::X), to(DVec3::Y), to(DVec3::Z)],
            [DVec3::NEG_X, DVec3::Y, DVec3::NEG_Z]
        );
        assert!(look_at([0.0; 3], [0.0, 1.0, 0.0], [0.0, 2.0, 0.0]).is_err());
    }
}

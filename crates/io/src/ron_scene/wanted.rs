//! The values that fields of a scene file want, in the words of its manual.

use super::context::Context;

const NUMBERS: &str = "three numbers, as `(0, 1, 4)`";
const COLOUR: &str = "red, green and blue, as `(0.5, 0.5, 0.5)`";
const PICTURE: &str = "a picture, as `\"wood.png\"` or `(file: \"wood.png\", scale: (4, 4))`";
const MATERIAL: &str = "a material, as `Lambert(reflectance: (0.5, 0.5, 0.5))`";
const NUMBER: &str = "a number, as `1.5`";

/// Returns the kind of value that a field wants, in words; `None` if it is not known.
pub(super) fn wanted(context: &Context<'_>) -> Option<&'static str> {
    if context.field.starts_with('"') {
        // Of a mesh, or of the file.
        let of_mesh = context.owner == Some("Mesh");
        return Some(if of_mesh { "the name of a material in quotes" } else { MATERIAL });
    }
    Some(match (context.owner, context.field) {
        (
            _,
            "position" | "target" | "up" | "corner" | "edge_u" | "edge_v" | "center" | "normal"
            | "a" | "b" | "c" | "min" | "max" | "translate",
        ) => NUMBERS,
        (_, "rotate") => "three angles in degrees, as `(-90, 0, 0)`",
        (Some("Textured"), "diffuse" | "specular" | "opacity") => PICTURE,
        (_, "bump") => "a picture and its height, as `(file: \"relief.png\", height: 0.02)`",
        (
            _,
            "reflectance" | "through" | "diffuse" | "specular" | "emission" | "intensity"
            | "radiance",
        ) => COLOUR,
        (_, "reflection" | "transmission") => "parts, as `(diffuse: (0.5, 0.5, 0.5))`",
        (_, "ends") => "two points, as `((0, 0, 0), (0, 1, 0))`",
        (_, "radii") => "two numbers, as `(0.5, 0.2)`",
        (_, "matrix") => "six numbers, as `(1, 0, 0, 1, 0.5, 0)`",
        (_, "resolution") => "width and height in pixels, as `(400, 300)`",
        (Some("Mesh"), "scale") => "one number, as `0.5`: a mesh keeps its proportions",
        (Some("Mesh"), "lights")
        | (Some("Picture"), "scale" | "turn")
        | (
            _,
            "fov" | "radius" | "inner" | "exponent" | "index" | "exposure" | "strength" | "height"
            | "glow" | "full" | "dark",
        ) => NUMBER,
        (_, "scale") => "two numbers, as `(4, 4)`",
        (_, "spp") => "a whole number above 0, as `64`",
        (_, "material") => "the name of a material in quotes, as `\"white\"`",
        (_, "file") => "the name of a file in quotes, as `\"wood.png\"`",
        (_, "sides") => "`Both` or `Front`",
        (_, "facing") => "`Outward` or `Inward`",
        (_, "tiling") => "`Repeat`, `Mirror` or `Once`",
        (_, "shape") => "a shape, as `Sphere(center: (0, 1, 0), radius: 0.5)`",
        (_, "base") => MATERIAL,
        (_, "camera") => {
            "`(position: (0, 1, 4), target: (0, 1, 0), fov: 40, resolution: (400, 300))`"
        }
        (Some("Mesh"), "materials") => "names for names, as `{\"of the file\": \"of the scene\"}`",
        (_, "materials") => "names with materials, as `{ \"white\": Lambert(…) }`",
        (_, "objects") => "a list of objects, as `[(shape: Sphere(…), material: \"white\")]`",
        (_, "lights") => "a list of lights, as `[Point(position: …, intensity: …)]`",
        (_, "sky") => "`Constant(radiance: (1, 1, 1))` or `Picture(file: \"sky.hdr\")`",
        (_, "include") => "a list of files, as `[\"room.ron\"]`",
        _ => return None,
    })
}

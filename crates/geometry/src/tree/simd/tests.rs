//! All instruction sets compute the same.

use super::{Avx2Simd, F32x4, F32x8, F64x4, F64x8, Float, PACKET, Portable, Simd, Sse41Simd};
use crate::testing::Random;
use std::array::from_fn;

/// Returns the results of all operations on two lists, as bits; what is not a number is the same
/// whatever its bits.
fn answers<E: Simd>(simd: E, a: [f32; PACKET], b: [f32; PACKET]) -> Vec<u64> {
    let (x, y) = (simd.load(a), simd.load(b));
    let of_both = [x + y, x - y, x * y, x / y, x.lesser(y), x.greater(y)];
    let of_one = [x.abs(), x.reciprocal()];
    let (v, w) = (x.widen(), y.widen());
    let doubles = [v + w, v - w, v * w, v / w, v.lesser(w), v.greater(w)];
    let exactly = simd.splat_double(1e-60);
    let narrow = doubles.map(|d| d.narrow().to_array()).into_iter().flatten();
    let four = |all: [f32; PACKET]| simd.load_four(from_fn(|i| all[i]));
    let (f, g) = (four(a), four(b));
    let fours = [f + g, f - g, f * g, f / g, f.lesser(g), f.greater(g), simd.splat_four(a[1])];
    let (d, e) = (simd.widen_four(f), simd.widen_four(g));
    let tiny = simd.splat_four_doubles(1e-60) * simd.load_four_doubles([1.0, -2.0, 0.5, -0.0]);
    let roots = [d.square_root(), d.with_signs_of(e), e.with_signs_of(tiny), tiny * d];
    let small = [(d * tiny).below(e * tiny), e.at_most(tiny)];
    let narrow = narrow.chain(roots.into_iter().flat_map(|d| d.narrow().to_array()));
    let masks = [
        [small[0], small[1], d.signs(), tiny.signs()],
        [x.below(y), x.at_most(y), x.signs(), y.signs()],
        [v.below(w), v.at_most(w), (v * exactly).below(w * exactly), w.at_most(v)],
        [f.below(g), f.at_most(g), g.below(f), g.at_most(f)],
    ];
    let product = simd.splat(b[0]).minus_product(x, y).to_array();
    let singles = of_both.into_iter().chain(of_one).flat_map(F32x8::to_array);
    let fours = fours.map(F32x4::to_array).into_iter().flatten();
    let numbers = singles.chain(narrow).chain(fours).chain(product);
    let numbers = numbers.map(|x| if x.is_nan() { u64::MAX } else { u64::from(x.to_bits()) });
    numbers.chain(masks.into_iter().flatten().map(u64::from)).collect()
}

fn avx2() -> Option<Avx2Simd> {
    let is_there = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
    // SAFETY: the machine has them.
    #[allow(unsafe_code)]
    is_there.then(|| unsafe { Avx2Simd::new() })
}

const SPECIAL: [f32; 12] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    f32::NAN,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::MAX,
    f32::MIN_POSITIVE,
    1e-45,
    -3.5e-20,
    2.25,
];

#[test]
fn operations_give_the_same_bits() {
    let mut random = Random::new(3);
    for round in 0..2000 {
        let mut number = || {
            let place = (random.number() * 48.0) as usize;
            SPECIAL.get(place).copied().unwrap_or_else(|| random.number() * 4.0 - 2.0)
        };
        let (a, b) = (from_fn(|_| number()), from_fn(|_| number()));
        let expected = answers(Portable, a, b);
        assert_eq!(answers(Sse41Simd, a, b), expected, "{round}: {a:?} {b:?}");
        if let Some(avx2) = avx2() {
            assert_eq!(answers(avx2, a, b), expected, "{round}: {a:?} {b:?}");
        }
    }
}

#[test]
fn the_least_and_the_greatest_of_eight_are_found() {
    fn check<E: Simd>(simd: E) {
        for place in 0..PACKET {
            let numbers = simd.load(from_fn(|i| ((i + place) % PACKET) as f32 - 3.0));
            assert_eq!([numbers.smallest(), numbers.largest()], [-3.0, 4.0]);
        }
    }
    check(Portable);
    check(Sse41Simd);
    avx2().into_iter().for_each(check);
}

/// A product once or twice rounded is within a rounding of the product and one of the result.
#[test]
fn a_difference_from_a_product_is_about_right() {
    fn check<E: Simd>(simd: E) {
        let mut random = Random::new(4);
        for _ in 0..1000 {
            let [a, b, c] = from_fn(|_| from_fn(|_| random.number() * 2.0 - 1.0));
            let about = simd.load(a).minus_about(simd.load(b), simd.load(c)).to_array();
            for i in 0..PACKET {
                let product = f64::from(b[i]) * f64::from(c[i]);
                let exact = f64::from(a[i]) - product;
                let room = f64::from(f32::EPSILON) * (product.abs() + exact.abs());
                assert!((f64::from(about[i]) - exact).abs() <= room, "{a:?} {b:?} {c:?}");
            }
        }
    }
    check(Portable);
    check(Sse41Simd);
    avx2().into_iter().for_each(check);
}

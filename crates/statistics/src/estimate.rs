//! A number and how well it is known.

/// An end of an interval further away than by this factor tells only that nothing is
/// known on that side, and is given as this. So is the high end of a mean that has no
/// variance, however far its values spread: most samples of such a law have no large value
/// in them, and lie below its mean.
pub const NOTHING_KNOWN: f64 = 100.0;

/// A number and the interval it lies in. An end [`NOTHING_KNOWN`] times away is none.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Estimate {
    /// The number.
    pub value: f64,
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

impl Estimate {
    /// Tells whether the low end is one.
    pub fn knows_low(&self) -> bool {
        self.low * NOTHING_KNOWN > NEARLY * self.value
    }

    /// Tells whether the high end is one.
    pub fn knows_high(&self) -> bool {
        self.high < self.value * NOTHING_KNOWN / NEARLY
    }

    /// Returns the estimate without a low end.
    #[must_use]
    pub fn without_low(self) -> Self {
        Self { low: self.value / NOTHING_KNOWN, ..self }
    }

    /// Returns the estimate without a high end.
    #[must_use]
    pub fn without_high(self) -> Self {
        Self { high: self.value * NOTHING_KNOWN, ..self }
    }

    /// A rising function of it; an end that is none stays so.
    #[must_use]
    pub fn map(self, of: impl Fn(f64) -> f64) -> Self {
        let Self { value, low, high } = self;
        let mapped = Self { value: of(value), low: of(low), high: of(high) };
        let mapped = if self.knows_low() { mapped } else { mapped.without_low() };
        if self.knows_high() { mapped } else { mapped.without_high() }
    }
}

/// Logarithms and back are not exact.
const NEARLY: f64 = 1.0 + 1e-9;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_end_that_is_none_stays_so() {
        let known = Estimate { value: 316.0, low: 103.0, high: 500.0 };
        assert!(known.knows_low() && known.knows_high());
        let half = known.map(|value| 0.5 * value);
        assert_eq!(half, Estimate { value: 158.0, low: 51.5, high: 250.0 });
        let open = known.without_high().map(|value| value.ln().exp());
        assert!(open.knows_low() && !open.knows_high());
        let none = known.without_low().without_high();
        assert!(!none.knows_low() && !none.knows_high());
    }
}

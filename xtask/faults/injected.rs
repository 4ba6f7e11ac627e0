//! Tells which fault is awake. `cargo xtask faults` puts this file and a list of all faults into a
//! copy of the sources; the sources themselves know nothing of it.

use std::sync::LazyLock;

/// Tells whether a fault is awake, by its name.
#[macro_export]
macro_rules! injected {
    ($fault:ident) => {
        $crate::faults::is_awake($crate::faults::Fault::$fault)
    };
}

macro_rules! faults {
    ($($fault:ident)*) => {
        /// A mistake that a renderer may well have.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Fault {
            $(
                /// Its patch says what is wrong.
                $fault,
            )*
        }

        const ALL: &[(&str, Fault)] = &[$((stringify!($fault), Fault::$fault)),*];
    };
}

/// Tells whether this fault is awake.
///
/// # Panics
/// If the environment names a fault that there is not: a run without it would pass
/// for a proof.
pub fn is_awake(fault: Fault) -> bool {
    static AWAKE: LazyLock<Option<Fault>> = LazyLock::new(|| {
        let name = std::env::var("TRAYLIB_FAULT").ok()?;
        let named = ALL.iter().find(|(known, _)| *known == name);
        assert!(named.is_some(), "TRAYLIB_FAULT: there is no fault {name}");
        named.map(|(_, fault)| *fault)
    });
    *AWAKE == Some(fault)
}


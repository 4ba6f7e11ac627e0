//! The part of Embree's C interface that is needed, as its documentation has it
//! (<https://www.embree.org/api.html>).

use super::Found;
use libloading::{Library as Shared, Symbol};
use std::ffi::{c_char, c_uint, c_void};
use std::ptr::null;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicIsize, Ordering::Relaxed};
use traylib_geometry::{Mesh, Ray, Vec3};

type Handle = *mut c_void;
type Query = unsafe extern "C" fn(Handle, *mut RayHit, *const c_void);
type Monitor = unsafe extern "C" fn(*mut c_void, isize, bool) -> bool;

const NONE: c_uint = u32::MAX;
const TRIANGLES: c_uint = 0;
const INDEX: c_uint = 0;
const VERTEX: c_uint = 1;
const UINT3: c_uint = 0x5003;
const FLOAT3: c_uint = 0x9003;

/// A ray, which Embree wants on 16 bytes, and the hit that it writes behind it.
/// For a question of any hit it looks at the ray alone.
#[repr(C, align(16))]
pub(super) struct RayHit {
    origin: [f32; 3],
    t_near: f32,
    direction: [f32; 3],
    time: f32,
    t_far: f32,
    mask: c_uint,
    id: c_uint,
    flags: c_uint,
    normal: [f32; 3],
    u: f32,
    v: f32,
    primitive: c_uint,
    geometry: c_uint,
    /// Instances; how many numbers these are depends on how Embree was compiled.
    instances: [c_uint; 9],
}

impl RayHit {
    #[inline]
    pub(super) fn new(ray: &Ray) -> Self {
        Self {
            origin: ray.origin.to_array(),
            t_near: 0.0,
            direction: ray.direction.to_array(),
            time: 0.0,
            t_far: ray.t_max,
            mask: u32::MAX,
            id: 0,
            flags: 0,
            normal: [0.0; 3],
            u: 0.0,
            v: 0.0,
            primitive: NONE,
            geometry: NONE,
            instances: [NONE; 9],
        }
    }

    #[inline]
    pub(super) fn found(&self) -> Found {
        if self.geometry == NONE {
            return Found::NOTHING;
        }
        Found { t: self.t_far, primitive: self.primitive }
    }
}

/// The loaded library. It stays: threads of its own may run on when its scenes are
/// gone.
pub(super) struct Library(Shared);

impl Library {
    /// The file that the environment names in `EMBREE4_LIB`, or what the system
    /// finds by the usual names.
    pub(super) fn find() -> Option<&'static Self> {
        static LIBRARY: OnceLock<Option<Library>> = OnceLock::new();
        LIBRARY.get_or_init(Self::load).as_ref()
    }

    fn load() -> Option<Self> {
        let named = std::env::var("EMBREE4_LIB").ok();
        let usual = ["libembree4.so.4", "libembree4.so", "libembree4.dylib", "embree4.dll"];
        let names = named.map_or(usual.map(String::from).to_vec(), |name| vec![name]);
        // SAFETY: loading runs the library's own start, which is trusted as it is asked for.
        names.iter().find_map(|name| unsafe { Shared::new(name) }.ok()).map(Self)
    }

    /// The function of this name, whose type the caller vouches for.
    unsafe fn get<F: Copy>(&self, name: &str) -> Result<F, String> {
        let symbol: Symbol<F> =
            unsafe { self.0.get(name.as_bytes()) }.map_err(|error| error.to_string())?;
        Ok(*symbol)
    }
}

/// A committed scene of one mesh, on a device of its own.
pub(super) struct Scene {
    loaded: &'static Library,
    device: Handle,
    handle: Handle,
    intersect: Query,
    occluded: Query,
    bytes: Box<AtomicIsize>,
}

unsafe extern "C" fn count(sum: *mut c_void, bytes: isize, _: bool) -> bool {
    // SAFETY: `sum` is the counter of the scene, which outlives its device.
    unsafe { &*sum.cast::<AtomicIsize>() }.fetch_add(bytes, Relaxed);
    true
}

impl Scene {
    /// # Errors
    /// Names of functions that the library lacks, and Embree's own error numbers.
    pub(super) fn new(
        library: &'static Library,
        mesh: &Mesh,
        quality: c_uint,
        flags: c_uint,
    ) -> Result<Self, String> {
        // SAFETY: types and order of calls are those of the documentation.
        unsafe {
            let new_device: unsafe extern "C" fn(*const c_char) -> Handle =
                library.get("rtcNewDevice")?;
            let new_scene: unsafe extern "C" fn(Handle) -> Handle = library.get("rtcNewScene")?;
            let device = new_device(null());
            if device.is_null() {
                return Err("no device".to_owned());
            }
            let bytes = Box::new(AtomicIsize::new(0));
            let scene = Self {
                loaded: library,
                device,
                intersect: library.get("rtcIntersect1")?,
                occluded: library.get("rtcOccluded1")?,
                handle: {
                    monitor(library, device, &bytes)?;
                    new_scene(device)
                },
                bytes,
            };
            scene.fill(mesh, quality, flags)?;
            Ok(scene)
        }
    }

    unsafe fn fill(&self, mesh: &Mesh, quality: c_uint, flags: c_uint) -> Result<(), String> {
        type Set = unsafe extern "C" fn(Handle, c_uint);
        type Do = unsafe extern "C" fn(Handle);
        let library = self.loaded;
        unsafe {
            library.get::<Set>("rtcSetSceneBuildQuality")?(self.handle, quality);
            library.get::<Set>("rtcSetSceneFlags")?(self.handle, flags);
            let new: unsafe extern "C" fn(Handle, c_uint) -> Handle =
                library.get("rtcNewGeometry")?;
            let attach: unsafe extern "C" fn(Handle, Handle) -> c_uint =
                library.get("rtcAttachGeometry")?;
            let geometry = new(self.device, TRIANGLES);
            library.get::<Set>("rtcSetGeometryBuildQuality")?(geometry, quality);
            let positions: Vec<_> = mesh.positions().iter().map(Vec3::to_array).collect();
            self.copy(geometry, VERTEX, FLOAT3, &positions)?;
            self.copy(geometry, INDEX, UINT3, mesh.triangles())?;
            library.get::<Do>("rtcCommitGeometry")?(geometry);
            attach(self.handle, geometry);
            library.get::<Do>("rtcReleaseGeometry")?(geometry);
            library.get::<Do>("rtcCommitScene")?(self.handle);
        }
        self.check()
    }

    /// Fills a buffer that Embree makes.
    unsafe fn copy<T: Copy>(
        &self,
        geometry: Handle,
        kind: c_uint,
        format: c_uint,
        items: &[[T; 3]],
    ) -> Result<(), String> {
        type New =
            unsafe extern "C" fn(Handle, c_uint, c_uint, c_uint, usize, usize) -> *mut c_void;
        unsafe {
            let new: New = self.loaded.get("rtcSetNewGeometryBuffer")?;
            let buffer = new(geometry, kind, 0, format, size_of::<[T; 3]>(), items.len());
            if buffer.is_null() {
                return self.check();
            }
            std::ptr::copy_nonoverlapping(items.as_ptr(), buffer.cast(), items.len());
        }
        Ok(())
    }

    fn check(&self) -> Result<(), String> {
        // SAFETY: the device lives as long as `self`.
        let error = unsafe {
            let get: unsafe extern "C" fn(Handle) -> c_uint =
                self.loaded.get("rtcGetDeviceError")?;
            get(self.device)
        };
        if error == 0 { Ok(()) } else { Err(format!("error {error}")) }
    }

    #[inline]
    pub(super) fn intersect(&self, query: &mut RayHit) {
        // SAFETY: the scene is committed, the query laid out and aligned as documented.
        unsafe { (self.intersect)(self.handle, query, null()) }
    }

    /// Embree marks a ray that meets anything by an end at −∞.
    #[inline]
    pub(super) fn occluded(&self, query: &mut RayHit) -> bool {
        // SAFETY: as above.
        unsafe { (self.occluded)(self.handle, query, null()) };
        query.t_far == f32::NEG_INFINITY
    }

    /// Returns the bytes that Embree said it took.
    pub(super) fn bytes(&self) -> usize {
        self.bytes.load(Relaxed).max(0) as usize
    }
}

/// Has the device report every piece of memory.
unsafe fn monitor(library: &Library, device: Handle, sum: &AtomicIsize) -> Result<(), String> {
    type SetMonitor = unsafe extern "C" fn(Handle, Option<Monitor>, *mut c_void);
    let sum = std::ptr::from_ref(sum).cast_mut().cast();
    unsafe {
        library.get::<SetMonitor>("rtcSetDeviceMemoryMonitorFunction")?(device, Some(count), sum);
    }
    Ok(())
}

impl Drop for Scene {
    fn drop(&mut self) {
        type Release = unsafe extern "C" fn(Handle);
        let Self { loaded: library, device, handle, .. } = self;
        // SAFETY: both are released once, the scene before its device.
        unsafe {
            if let Ok(release) = library.get::<Release>("rtcReleaseScene") {
                release(*handle);
            }
            if let Ok(release) = library.get::<Release>("rtcReleaseDevice") {
                release(*device);
            }
        }
    }
}

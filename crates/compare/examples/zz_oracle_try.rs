//! try
#![allow(missing_docs, clippy::all)]
fn main() {
    for quick in [true, false] {
        let t = std::time::Instant::now();
        let o = traylib_compare::oracle::oracle(quick, &|s| {
            eprintln!("{:.2} {s}", t.elapsed().as_secs_f64())
        });
        println!("{}", serde_json::to_string(&o).unwrap());
        println!(
            "quick {quick}: {:.2} s; {:?} {:?}",
            t.elapsed().as_secs_f64(),
            o.crossing,
            o.crossing_in_time
        );
        for c in &o.curves {
            for p in &c.points {
                println!(
                    "{} {} {:.5e} {:.5e} [{:.5e} {:.5e}] {:.3e} s {}",
                    c.method,
                    p.radius,
                    p.theory,
                    p.variance.value,
                    p.variance.low,
                    p.variance.high,
                    p.seconds,
                    (p.variance.low..=p.variance.high).contains(&p.theory)
                );
            }
        }
    }
    for name in ["cornell", "pyramid"] {
        let t = std::time::Instant::now();
        let l = traylib_io::load_scene_with(
            name,
            traylib_io::LoadOptions { resolution: Some((160, 120)) },
        )
        .unwrap();
        let r = traylib_compare::lengths::lengths(&l.scene, 1e-3, 16).unwrap();
        println!("{name} lengths {:.2} s", t.elapsed().as_secs_f64());
        for s in &r {
            println!("{} light {:.5} var {:.5} rays {:.5}", s.edges, s.light, s.variance, s.rays);
        }
        let t = std::time::Instant::now();
        let p = traylib_compare::techniques::technique_pictures(&l.scene, 16).unwrap();
        println!("techniques {} {:.2} s", p.len(), t.elapsed().as_secs_f64());
    }
}

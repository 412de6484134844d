// As driver.c.
use std::io::BufRead;
//: each
mod LIBRARY;
//: end

macro_rules! call {
    ($library:ident, $x:expr) => {{
        use $library::*;
        let x: Vec<f64> = $x;
        assert_eq!(std::mem::size_of::<Parameters>(), 8 * x.len());
        let p = unsafe { std::ptr::read(x.as_ptr() as *const Parameters) };
        let (a, f) = (critical_velocity_certified(&p), fast_critical_velocity_certified(&p));
        let mut batch = [0.0; 2];
        critical_velocity_batch(&p, &x[1..2], &mut batch[..1]);
        fast_critical_velocity_batch(&p, &x[1..2], &mut batch[1..]);
        let mut all = vec![a.value, a.relative_error_bound, f.value, f.relative_error_bound];
        all.extend([critical_velocity(&p), fast_critical_velocity(&p), batch[0], batch[1]]);
        if WITH_GRADIENTS == 1 {
            for g in [critical_velocity_gradient(&p), fast_critical_velocity_gradient(&p)] {
                let partial = &g.partial as *const Parameters as *const f64;
                all.push(g.value);
                all.extend(unsafe { std::slice::from_raw_parts(partial, x.len()) });
            }
        }
        all
    }};
}

fn main() {
    for line in std::io::stdin().lock().lines() {
        let line = line.unwrap();
        let mut words = line.split(' ');
        let library: usize = words.next().unwrap().parse().unwrap();
        let x = words.map(|word| word.parse().unwrap()).collect();
        let all: Vec<f64> = match library {
//: each
            NUMBER => call!(LIBRARY, x),
//: end
            _ => panic!("no such library"),
        };
        println!("{}", all.iter().map(|y| format!("{:?} ", y)).collect::<String>());
    }
}

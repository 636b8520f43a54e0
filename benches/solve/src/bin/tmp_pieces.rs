use kerfway::solve::papers;
use kerfway_bench_solve::source::Source;
use std::time::Instant;
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let mut s = Source::read(&a[1]).unwrap().remove(0);
    if a.len() > 4 { for i in &mut s.problem.items { if i.track.is_some() { i.leave = Some(0.0); } } }
    if a.len() > 5 { for i in &mut s.problem.items { i.before = None; i.rank = 0; } }
    println!("{} items {} nodes, before {}", s.problem.items.len(), s.problem.nodes.len(), s.problem.items.iter().filter(|i| i.before.is_some()).count());
    let t = Instant::now();
    let m = papers::method(&a[2], "{}").unwrap();
    let mut search = m.start(&s.problem, 1, None);
    let begin = t.elapsed().as_secs_f64();
    let end: f64 = a[3].parse().unwrap();
    let t = Instant::now();
    let (mut worst, mut n, mut all) = (0.0_f64, 0, vec![]);
    while t.elapsed().as_secs_f64() < end { let u = Instant::now(); search.step(20_000); let d = u.elapsed().as_secs_f64(); worst = worst.max(d); all.push(d); n += 1; }
    all.sort_by(f64::total_cmp);
    let rss = std::fs::read_to_string("/proc/self/status").unwrap().lines().find(|l| l.starts_with("VmHWM")).unwrap().to_string();
    println!("{} start {:.1} ms, steps {n} median {:.2} p99 {:.2} worst {:.1} ms, round {} {}", a[2], 1e3*begin, 1e3*all[all.len()/2], 1e3*all[all.len()*99/100], 1e3*worst, search.insight().round, rss);
}

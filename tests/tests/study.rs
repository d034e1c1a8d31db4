//! Studies of real scenes: what they must find, and how their page looks in a browser.

use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::net::{TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use clap::Parser;
use strahl::args::StudyArgs;
use strahl_core::Resolution;
use strahl_engine::NoProgress;
use strahl_scene::load;
use strahl_settings::Effect;
use strahl_settings::Settings;
use strahl_study::measure::benchmark::Bench;
use strahl_study::measure::experiment;
use strahl_study::measure::measurements::{Measurements, ReferencePicture};
use strahl_study::measure::plan::Plan;
use strahl_study::pareto::{Point, front};
use strahl_study::record::Step;

fn scene(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes").join(name)
}

/// Studies a scene without a clock, so that the same is measured on every machine.
fn studied<T>(
    name: &str,
    plan: &Plan,
    asks: &[Effect],
    then: impl FnOnce(&Measurements<'_>, &ReferencePicture) -> T,
) -> T {
    let path = scene(name);
    let scene = load(&path).unwrap();
    let size = Resolution::new(40, 25).unwrap();
    let bench = Bench::new(&scene, size, &NoProgress, None);
    let mut measured = Measurements::new(&bench, plan);
    let settings = Settings { size, threads: 2, ..Settings::default() };
    let reference = experiment::run(&mut measured, &settings, asks).unwrap();
    then(&measured, &reference)
}

/// The steps of a knob: values, and the errors that they make alone.
fn steps<'c>(measured: &'c Measurements<'_>, knob: &str) -> &'c [Step] {
    &measured.knobs.iter().find(|it| it.name == knob).unwrap_or_else(|| panic!("no {knob}")).steps
}

#[test]
fn the_error_of_stochastic_sampling_falls_as_it_must() {
    let plan = Plan {
        reference: [1024, 1024],
        stochastic: &[4, 16, 64],
        regular: &[],
        adaptive: &[],
        stopping: &[],
        mixes: 0,
        repeats: 1,
        ..Plan::QUICK
    };
    studied("penumbra.toml", &plan, &[Effect::Penumbra], |conduct, truth| {
        let error = |samples: &str| {
            let value = format!("stochastic:{samples}");
            steps(conduct, "sampler").iter().find(|step| step.value == value).unwrap().alone.rmse
        };
        let errors = ["4", "16", "64"].map(error);
        assert!(truth.reference.noise < 0.3 * errors[2], "{} {errors:?}", truth.reference.noise);
        // Chance alone gives N^-0.5; a sequence of low discrepancy does better, at most N^-1.
        for two in errors.windows(2) {
            let slope = (two[1] / two[0]).ln() / 4_f64.ln();
            assert!(slope < -0.45 && slope > -1.1, "{errors:?}: {slope}");
        }
    });
}

#[test]
fn no_knob_makes_a_picture_worse_where_it_is_finer() {
    let plan =
        Plan { reference: [64, 64], regular: &[2], stochastic: &[4], repeats: 1, mixes: 6, ..Plan::QUICK };
    studied("classic.toml", &plan, &[Effect::Reflection, Effect::Transmission], |conduct, _| {
        for knob in ["levels", "cutoff"] {
            let steps = steps(conduct, knob);
            assert!(steps.len() > 3, "{knob}");
            for two in steps.windows(2) {
                assert!(
                    two[1].alone.rmse <= two[0].alone.rmse,
                    "{knob} {} -> {}",
                    two[0].value,
                    two[1].value
                );
            }
        }
        for it in conduct.techniques.iter().filter(|it| it.exact) {
            let digest = |run: Option<usize>| conduct.taken[run.unwrap()].run.digest.as_str();
            assert_eq!(digest(it.with), digest(it.without), "{}", it.name);
        }
        // What an effect does is more than what is left of chance.
        let without = steps(conduct, "without");
        let (all, left_out) = without.split_last().unwrap();
        assert_eq!((all.value.as_str(), left_out.len()), ("nothing", 2));
        assert!(left_out.iter().all(|step| step.alone.rmse > 2.0 * all.alone.rmse));
        // Mixtures reach the front.
        let points: Vec<Point> =
            conduct.taken.iter().map(|it| Point { cost: it.run.work, error: it.run.error.rmse }).collect();
        assert!(front(&points).len() >= 3);
        assert!(conduct.beaten > 0, "nothing was left out as beaten");
    });
}

/// A server on this machine that has pages, and remembers what they asked it for.
struct Server {
    address: String,
    asked: Arc<Mutex<Vec<String>>>,
}

/// A page that asks for a picture somewhere else.
const FETCHING: &str = "<!DOCTYPE html><title>x</title><img src=\"http://elsewhere.test/picture.png\">";

/// How wide the frames are in which [`FRAMES`] has the report, and how high.
const WIDE: u32 = 1280;
const NARROW: u32 = 500;
const HEIGHT: u32 = 1800;

/// The report twice, as in a wide window and in a narrow one, and the page that asks for something.
const FRAMES: &str = "<!DOCTYPE html><title>x</title><link rel=icon href=data:,>\
    <style>body { margin: 0; display: flex } iframe { border: 0; height: 1800px; flex: none }</style>\
    <iframe src=report.html?wide style=width:1280px></iframe>\
    <iframe src=report.html?narrow style=width:500px></iframe>\
    <iframe src=fetching.html style=width:20px></iframe>";

impl Server {
    fn of(report: Vec<u8>) -> Self {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let address = listener.local_addr().unwrap().to_string();
        let asked = Arc::new(Mutex::new(Vec::new()));
        let (heard, report) = (Arc::clone(&asked), Arc::new(report));
        std::thread::spawn(move || {
            for stream in listener.incoming().flatten() {
                let (heard, report) = (Arc::clone(&heard), Arc::clone(&report));
                // Browsers open connections before they need them: none waits for another.
                std::thread::spawn(move || answer(stream, &report, &heard));
            }
        });
        Server { address, asked }
    }

    /// What pages have asked for until now, in the order of names.
    fn asked(&self) -> Vec<String> {
        let mut asked = std::mem::take(&mut *self.asked.lock().unwrap());
        asked.sort();
        asked
    }
}

fn answer(mut stream: TcpStream, report: &[u8], asked: &Mutex<Vec<String>>) {
    let mut line = String::new();
    let mut reader = BufReader::new(stream.try_clone().unwrap());
    // A connection that says nothing, or no text, asks for nothing of ours.
    if reader.read_line(&mut line).unwrap_or(0) == 0 {
        return;
    }
    let what = line.split(' ').nth(1).unwrap_or_default();
    // Browsers ask for their own updates too; only pages are named as those who refer.
    let mut is_of_page = what.contains(".html");
    let mut header = String::new();
    while reader.read_line(&mut header).unwrap_or(0) > 2 {
        is_of_page |= header.to_ascii_lowercase().starts_with("referer:");
        header.clear();
    }
    if is_of_page {
        asked.lock().unwrap().push(what.to_owned());
    }
    let body = match what {
        "/frames.html" => FRAMES.as_bytes(),
        "/fetching.html" => FETCHING.as_bytes(),
        _ => report,
    };
    let head = format!(
        "HTTP/1.1 200 OK\r\nContent-Type: text/html\r\nContent-Length: {}\r\nConnection: close\r\n\r\n",
        body.len()
    );
    let _ = stream.write_all(head.as_bytes()).and_then(|()| stream.write_all(body));
}

/// Chromium, where it is installed.
fn chromium() -> Option<&'static str> {
    let is_there = |name: &&str| {
        let asked = Command::new(name).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
        asked.is_ok_and(|status| status.success())
    };
    ["chromium", "chromium-browser", "google-chrome"].into_iter().find(is_there)
}

/// A page as a window of this width shows it, from its top.
fn shown(browser: &str, folder: &Path, url: &str, width: u32, scheme: &[&str]) -> image::RgbImage {
    let address = url.split('/').nth(2).unwrap();
    let file = folder.join(format!("{width}.png"));
    let mut child = Command::new(browser)
        .args(["--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--no-first-run"])
        .args([
            "--disable-background-networking",
            "--disable-component-update",
            "--disable-sync",
            "--disable-extensions",
        ])
        // Whatever the page asks of anybody comes to the server.
        .arg(format!("--host-resolver-rules=MAP * {address}"))
        .arg(format!("--user-data-dir={}", folder.join("profile").display()))
        .arg(format!("--window-size={width},{HEIGHT}"))
        .arg(format!("--screenshot={}", file.display()))
        .args(scheme)
        .arg(url)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let start = Instant::now();
    while child.try_wait().unwrap().is_none() {
        if start.elapsed() > Duration::from_secs(120) {
            child.kill().unwrap();
            panic!("the browser does not end");
        }
        std::thread::sleep(Duration::from_millis(50));
    }
    image::open(&file).unwrap().to_rgb8()
}

/// How many pixels have this colour.
fn pixels(picture: &image::RgbImage, color: [u8; 3]) -> usize {
    picture.pixels().filter(|pixel| pixel.0.iter().zip(color).all(|(a, b)| a.abs_diff(b) <= 3)).count()
}

#[test]
fn the_page_shows_its_plots_in_a_browser_and_fetches_nothing() {
    let Some(browser) = chromium() else {
        eprintln!("skipped: Chromium is not installed");
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let path = scene("classic.toml");
    let out = folder.path().join("out");
    let words = ["study", path.to_str().unwrap(), "-o", out.to_str().unwrap(), "--size", "48x36"];
    let args = StudyArgs::parse_from([&words[..], &["--time-limit", "4s", "--quiet"]].concat());
    strahl::study_command::run(&args).unwrap();
    let server = Server::of(fs::read(out.join("report.html")).unwrap());
    let shown = |page: &str, width, scheme: &[&str]| {
        shown(browser, folder.path(), &format!("http://{}/{page}", server.address), width, scheme)
    };

    // The colours of paper, of one ray and of regular sampling in light and dark, as the style has them.
    let light = shown("frames.html", WIDE + NARROW + 20, &[]);
    for (name, first, width) in [("wide", 0, WIDE), ("narrow", WIDE, NARROW)] {
        let frame = image::imageops::crop_imm(&light, first, 0, width, HEIGHT).to_image();
        assert!(pixels(&frame, [0xfb, 0xfa, 0xf8]) > frame.pixels().len() / 2, "{name}: the paper is light");
        assert!(pixels(&frame, [0x47, 0x4d, 0x57]) > 40, "{name}: marks of single rays are there");
        assert!(pixels(&frame, [0x00, 0x72, 0xb2]) > 40, "{name}: marks of regular sampling are there");
    }
    // A page that fetches something is found out, and the report fetches nothing.
    let pages =
        ["/fetching.html", "/frames.html", "/picture.png", "/report.html?narrow", "/report.html?wide"];
    assert_eq!(server.asked(), pages);

    let dark = shown("report.html", WIDE, &["--blink-settings=preferredColorScheme=0"]);
    assert!(pixels(&dark, [0x12, 0x14, 0x17]) > dark.pixels().len() / 2, "the paper is dark");
    assert!(pixels(&dark, [0xc9, 0xcd, 0xd4]) > 60, "marks of single rays are there");
    assert_eq!(server.asked(), ["/report.html"]);
}

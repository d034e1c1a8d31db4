//! Studies of real scenes: their results, and their report page in a browser.

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
use strahl_settings::OptionalEffect;
use strahl_settings::Settings;
use strahl_study::measure::benchmark::Benchmark;
use strahl_study::measure::experiment;
use strahl_study::measure::measurements::{Measurements, ReferencePicture};
use strahl_study::measure::plan::StudyPlan;
use strahl_study::pareto::{CostErrorPoint, pareto_front};
use strahl_study::record::SweepPoint;

fn scene(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes").join(name)
}

/// Studies a scene without a time limit, so that every machine measures the same.
fn studied<T>(
    name: &str,
    plan: &StudyPlan,
    effects: &[OptionalEffect],
    then: impl FnOnce(&Measurements<'_>, &ReferencePicture) -> T,
) -> T {
    let path = scene(name);
    let scene = load(&path).unwrap();
    let size = Resolution::new(40, 25).unwrap();
    let bench = Benchmark::new(&scene, size, &NoProgress, None);
    let mut measured = Measurements::new(&bench, plan);
    let settings = Settings { size, threads: 2, ..Settings::default() };
    let reference = experiment::run(&mut measured, &settings, effects).unwrap();
    then(&measured, &reference)
}

/// The steps of a setting: values, and the error of each alone.
fn steps<'c>(measured: &'c Measurements<'_>, setting: &str) -> &'c [SweepPoint] {
    &measured.sweeps.iter().find(|it| it.name == setting).unwrap_or_else(|| panic!("no {setting}")).steps
}

#[test]
fn the_error_of_stochastic_sampling_falls_as_it_must() {
    let plan = StudyPlan {
        reference: [1024, 1024],
        stochastic: &[4, 16, 64],
        regular: &[],
        adaptive: &[],
        stochastic_stopping: &[],
        combinations: 0,
        repeats: 1,
        ..StudyPlan::QUICK
    };
    studied("penumbra.toml", &plan, &[OptionalEffect::SoftShadows], |conduct, truth| {
        let error = |samples: &str| {
            let value = format!("stochastic:{samples}");
            steps(conduct, "sampler").iter().find(|step| step.value == value).unwrap().alone.rmse
        };
        let errors = ["4", "16", "64"].map(error);
        assert!(truth.reference.noise < 0.3 * errors[2], "{} {errors:?}", truth.reference.noise);
        // Independent random samples give N^-0.5, a low-discrepancy sequence up to N^-1.
        for two in errors.windows(2) {
            let slope = (two[1] / two[0]).ln() / 4_f64.ln();
            assert!(slope < -0.45 && slope > -1.1, "{errors:?}: {slope}");
        }
    });
}

#[test]
fn no_finer_value_of_a_setting_makes_a_picture_worse() {
    let plan = StudyPlan {
        reference: [64, 64],
        regular: &[2],
        stochastic: &[4],
        repeats: 1,
        combinations: 6,
        ..StudyPlan::QUICK
    };
    studied(
        "classic.toml",
        &plan,
        &[OptionalEffect::Reflection, OptionalEffect::Transmission],
        |conduct, _| {
            for setting in ["levels", "cutoff"] {
                let steps = steps(conduct, setting);
                assert!(steps.len() > 3, "{setting}");
                for two in steps.windows(2) {
                    assert!(
                        two[1].alone.rmse <= two[0].alone.rmse,
                        "{setting} {} -> {}",
                        two[0].value,
                        two[1].value
                    );
                }
            }
            for it in conduct.techniques.iter().filter(|it| it.exact) {
                let digest = |run: Option<usize>| conduct.measurements[run.unwrap()].run.digest.as_str();
                assert_eq!(digest(it.with), digest(it.without), "{}", it.name);
            }
            // Leaving out an effect changes the picture by more than the noise.
            let without = steps(conduct, "without");
            let (all, left_out) = without.split_last().unwrap();
            assert_eq!((all.value.as_str(), left_out.len()), ("nothing", 2));
            assert!(left_out.iter().all(|step| step.alone.rmse > 2.0 * all.alone.rmse));
            // Combinations are on the front.
            let points: Vec<CostErrorPoint> = conduct
                .measurements
                .iter()
                .map(|it| CostErrorPoint { cost: it.run.work, error: it.run.error.rmse })
                .collect();
            assert!(pareto_front(&points).len() >= 3);
            assert!(conduct.dominated > 0, "no dominated setting was left out");
        },
    );
}

/// A local server that provides pages and records their requests.
struct TestServer {
    address: String,
    requests: Arc<Mutex<Vec<String>>>,
}

/// A page that requests a picture from another host.
const FETCHING: &str = "<!DOCTYPE html><title>x</title><img src=\"http://elsewhere.test/picture.png\">";

/// Widths and height, in pixels, of the frames of [`FRAMES`].
const WIDE: u32 = 1280;
const NARROW: u32 = 500;
const HEIGHT: u32 = 1800;

/// The report in a wide and in a narrow frame, and the page that requests something.
const FRAMES: &str = "<!DOCTYPE html><title>x</title><link rel=icon href=data:,>\
    <style>body { margin: 0; display: flex } iframe { border: 0; height: 1800px; flex: none }</style>\
    <iframe src=report.html?wide style=width:1280px></iframe>\
    <iframe src=report.html?narrow style=width:500px></iframe>\
    <iframe src=fetching.html style=width:20px></iframe>";

impl TestServer {
    fn of(report: Vec<u8>) -> Self {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let address = listener.local_addr().unwrap().to_string();
        let requests = Arc::new(Mutex::new(Vec::new()));
        let (recorded, report) = (Arc::clone(&requests), Arc::new(report));
        std::thread::spawn(move || {
            for stream in listener.incoming().flatten() {
                let (recorded, report) = (Arc::clone(&recorded), Arc::clone(&report));
                // Browsers open connections before they need them: each has a thread.
                std::thread::spawn(move || answer(stream, &report, &recorded));
            }
        });
        TestServer { address, requests }
    }

    /// Returns the paths that pages have requested since the last call, sorted.
    fn requests(&self) -> Vec<String> {
        let mut requests = std::mem::take(&mut *self.requests.lock().unwrap());
        requests.sort();
        requests
    }
}

fn answer(mut stream: TcpStream, report: &[u8], requests: &Mutex<Vec<String>>) {
    let mut line = String::new();
    let mut reader = BufReader::new(stream.try_clone().unwrap());
    // A connection without a request line is ignored.
    if reader.read_line(&mut line).unwrap_or(0) == 0 {
        return;
    }
    let path = line.split(' ').nth(1).unwrap_or_default();
    // Browsers also request their own updates; only requests of pages have a referrer.
    let mut is_of_page = path.contains(".html");
    let mut header = String::new();
    while reader.read_line(&mut header).unwrap_or(0) > 2 {
        is_of_page |= header.to_ascii_lowercase().starts_with("referer:");
        header.clear();
    }
    if is_of_page {
        requests.lock().unwrap().push(path.to_owned());
    }
    let body = match path {
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

/// The name of an installed Chromium, if any.
fn chromium() -> Option<&'static str> {
    let is_there = |name: &&str| {
        let status = Command::new(name).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
        status.is_ok_and(|status| status.success())
    };
    ["chromium", "chromium-browser", "google-chrome"].into_iter().find(is_there)
}

/// Screenshot of the top of a page in a window of this width.
fn screenshot(browser: &str, folder: &Path, url: &str, width: u32, scheme: &[&str]) -> image::RgbImage {
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
        // All requests go to the server.
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
            panic!("the browser does not exit");
        }
        std::thread::sleep(Duration::from_millis(50));
    }
    image::open(&file).unwrap().to_rgb8()
}

/// Number of pixels with this color.
fn pixels(picture: &image::RgbImage, color: [u8; 3]) -> usize {
    picture.pixels().filter(|pixel| pixel.0.iter().zip(color).all(|(a, b)| a.abs_diff(b) <= 3)).count()
}

#[test]
fn the_page_shows_its_plots_in_a_browser_and_requests_nothing() {
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
    let server = TestServer::of(fs::read(out.join("report.html")).unwrap());
    let screenshot = |page: &str, width, scheme: &[&str]| {
        screenshot(browser, folder.path(), &format!("http://{}/{page}", server.address), width, scheme)
    };

    // The colors of the background, of single rays and of regular sampling, in light and dark mode, as in the
    // style sheet.
    let light = screenshot("frames.html", WIDE + NARROW + 20, &[]);
    for (name, first, width) in [("wide", 0, WIDE), ("narrow", WIDE, NARROW)] {
        let frame = image::imageops::crop_imm(&light, first, 0, width, HEIGHT).to_image();
        assert!(
            pixels(&frame, [0xfb, 0xfa, 0xf8]) > frame.pixels().len() / 2,
            "{name}: the background is light"
        );
        assert!(pixels(&frame, [0x47, 0x4d, 0x57]) > 40, "{name}: marks of single rays are visible");
        assert!(pixels(&frame, [0x00, 0x72, 0xb2]) > 40, "{name}: marks of regular sampling are visible");
    }
    // Requests of a page are recorded, and the report makes none.
    let pages =
        ["/fetching.html", "/frames.html", "/picture.png", "/report.html?narrow", "/report.html?wide"];
    assert_eq!(server.requests(), pages);

    let dark = screenshot("report.html", WIDE, &["--blink-settings=preferredColorScheme=0"]);
    assert!(pixels(&dark, [0x12, 0x14, 0x17]) > dark.pixels().len() / 2, "the background is dark");
    assert!(pixels(&dark, [0xc9, 0xcd, 0xd4]) > 60, "marks of single rays are visible");
    assert_eq!(server.requests(), ["/report.html"]);
}

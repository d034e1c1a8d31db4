//! What `study` writes, and what it refuses.

use std::fs;
use std::path::Path;
#[cfg(unix)]
use std::process::{Command, Stdio};
use std::sync::OnceLock;
use std::time::{Duration, Instant};

use serde_json::Value;
use strahl_study::record::file::schema;
use strahl_study::record::{RunRole, Study};

#[cfg(unix)]
use crate::program::Running;
use crate::program::{BALL, EMPTY, Folder};

const DEVICE: &str = "scene,width,height,precision,levels,cutoff,sampler,instructions,rays,rmse";

/// A study of a small scene with mirrors and glass, made once.
fn folder() -> &'static Folder {
    static FOLDER: OnceLock<Folder> = OnceLock::new();
    FOLDER.get_or_init(|| {
        let folder = Folder::with(BALL);
        let said = folder.run("study scene.nff -o out --size 32x24 --time-limit 40s");
        assert_eq!(said.status, Some(0), "{}", said.stderr);
        assert!(said.stderr.contains("out/report.html"), "{}", said.stderr);
        assert_eq!(said.stdout, b"");
        folder
    })
}

fn study() -> Study {
    Study::parse(&std::fs::read(folder().path("out/study.json")).unwrap()).unwrap()
}

fn page(folder: &str) -> String {
    String::from_utf8(self::folder().read(&format!("{folder}/report.html"))).unwrap()
}

/// The study with one thing changed, in a folder of its own.
fn changed(name: &str, change: impl Fn(&mut Value)) {
    let mut json: Value = serde_json::from_slice(&folder().read("out/study.json")).unwrap();
    change(&mut json);
    fs::create_dir(folder().path(name)).unwrap();
    folder().write(&format!("{name}/study.json"), json.to_string());
}

#[test]
fn a_study_is_a_page_a_table_and_all_that_was_measured() {
    let mut names: Vec<_> = fs::read_dir(folder().path("out"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    assert_eq!(names, ["report.html", "study.csv", "study.json"]);
    let study = study();
    assert_eq!((study.version, study.scene.name.as_str()), (1, "scene"));
    assert_eq!((study.scene.width, study.scene.height, study.scene.objects), (32, 24, 3));
    assert!(study.runs.iter().any(|run| run.role == RunRole::Own));
    for run in &study.runs {
        assert_eq!(run.cpu_seconds.len(), run.elapsed_seconds.len());
        assert!(run.work > 0.0 && run.error.ssim <= 1.0, "{run:?}");
    }

    let table = String::from_utf8(folder().read("out/study.csv")).unwrap();
    let mut lines = table.lines();
    let header: Vec<_> = lines.next().unwrap().split(',').collect();
    assert_eq!(header[..5], ["run", "role", "levels", "cutoff", "sampler"]);
    assert_eq!(lines.clone().count(), study.runs.len());
    assert!(lines.all(|line| line.split(',').count() == header.len()));
}

#[test]
fn more_levels_never_make_a_picture_worse() {
    let study = study();
    let levels = study.knobs.iter().find(|knob| knob.name == "levels").unwrap();
    assert!(levels.steps.len() > 3);
    for two in levels.steps.windows(2) {
        assert!(two[1].alone.rmse <= two[0].alone.rmse, "{} -> {}", two[0].value, two[1].value);
    }
    assert_eq!(levels.steps.last().unwrap().alone.rmse, 0.0);
}

#[test]
fn techniques_that_buy_time_make_no_error_at_all() {
    let study = study();
    let exact: Vec<_> = study.techniques.iter().filter(|it| it.exact).collect();
    assert!(exact.len() >= 9);
    let mut compared = 0;
    for it in exact {
        if let (Some(with), Some(without)) = (it.with, it.without) {
            assert_eq!(study.runs[with].digest, study.runs[without].digest, "{}", it.name);
            assert_eq!(it.error.unwrap().largest, 0.0, "{}", it.name);
            compared += 1;
        }
    }
    assert!(compared >= 9, "only {compared} were compared");
    let [one, others @ ..] = &study.threads[..] else { panic!("no threads") };
    assert!(others.iter().all(|run| study.runs[*run].digest == study.runs[*one].digest));
}

#[test]
fn the_page_needs_nothing_but_itself() {
    let page = page("out");
    assert!(page.starts_with("<!DOCTYPE html>") && page.ends_with("</html>\n"));
    for outside in
        ["<script", "src=\"http", "href=\"http", "url(", "@import", "<iframe", "<object", "<link rel=\"style"]
    {
        assert!(!page.contains(outside), "{outside}");
    }
    let inside = page.matches("src=\"").count();
    assert_eq!(inside, page.matches("src=\"data:image/png;base64,").count());
    assert!(inside >= 5);
    // Every picture and every plot says what is to be seen.
    assert_eq!(page.matches("<img ").count(), page.matches(" alt=\"").count());
    assert_eq!(page.matches("role=\"img\"").count(), page.matches("role=\"img\" aria-label=\"").count());
}

#[test]
fn the_page_is_made_again_from_what_was_measured() {
    changed("same", |_| {});
    let ran = folder().run("study --from same/study.json");
    assert_eq!(ran.status, Some(0), "{}", ran.stderr);
    assert_eq!(page("same"), page("out"));
    assert_eq!(folder().read("same/study.csv"), folder().read("out/study.csv"));
}

#[test]
fn a_page_that_is_made_elsewhere_has_its_numbers_beside_it() {
    folder().done("study --from out/study.json -o deep/elsewhere --quiet");
    assert_eq!(folder().read("deep/elsewhere/study.json"), folder().read("out/study.json"));
    // The page is written beside the file, and `study.json` there is not overwritten.
    changed("kept", |json| json["scene"]["name"] = "other".into());
    fs::copy(folder().path("out/study.json"), folder().path("kept/first.json")).unwrap();
    let before = folder().read("kept/study.json");
    folder().done("study --from kept/first.json --quiet");
    assert_eq!(folder().read("kept/study.json"), before);
}

#[test]
fn a_setting_that_was_not_measured_is_distinguished_from_one_without_effect() {
    let turned = |name: &str, left_out: usize| {
        changed(name, |json| {
            for knob in json["knobs"].as_array_mut().unwrap().iter_mut().filter(|it| it["name"] == "cutoff") {
                knob["steps"].as_array_mut().unwrap().truncate(1);
                knob["left_out"] = left_out.into();
            }
            let left = serde_json::json!({"setting": "--levels 5 --cutoff 1/8", "why": "no time was left"});
            json["left_out"] = vec![left; left_out].into();
        });
        folder().done(&format!("study --from {name}/study.json --quiet"));
        page(name)
    };
    let (unknown, fixed) = (turned("unknown", 4), turned("fixed", 0));
    assert!(unknown.contains("<code>cutoff</code>: not measured: no time was left (4 settings)."));
    assert!(!unknown.contains("has no effect in this scene"));
    assert!(unknown.contains("4 settings not measured: no time was left; cutoff was not measured"));
    assert!(fixed.contains("<code>cutoff</code> has no effect in this scene"));
    assert!(!fixed.contains("no time was left"));
}

#[test]
fn what_was_not_measured_has_no_empty_chart_or_table() {
    changed("bare", |json| {
        json["techniques"].as_array_mut().unwrap().iter_mut().for_each(|it| {
            (it["with"], it["without"], it["error"]) = (Value::Null, Value::Null, Value::Null);
        });
        json["threads"] = serde_json::json!([0]);
    });
    folder().done("study --from bare/study.json --quiet");
    let page = page("bare");
    let techniques = page.split("<section id=\"techniques\">").nth(1).unwrap();
    let techniques = techniques.split("</section>").next().unwrap();
    assert!(techniques.contains("Not completed: no time was left ("), "{techniques}");
    assert!(!techniques.contains("<svg") && !techniques.contains("<table"), "{techniques}");
}

#[test]
fn a_reference_that_cuts_much_light_is_reported_before_anything_else() {
    changed("coarse", |json| json["reference"]["cut"] = 0.031.into());
    let ran = folder().run("study --from coarse/study.json");
    assert_eq!(ran.status, Some(0), "{}", ran.stderr);
    let coarse = page("coarse");
    let at = |page: &str, text: &str| page.find(text).unwrap_or(usize::MAX);
    assert!(at(&coarse, "The reference discards 3.1 % of the light") < at(&coarse, "<section"));
    changed("clean", |json| json["reference"]["cut"] = 0.0001.into());
    folder().done("study --from clean/study.json --quiet");
    assert!(!page("clean").contains("The reference discards"));
    // The summary on the terminal reports it after a study.
    let study = |cut: f64| {
        let mut study = self::study();
        study.reference.cut = cut;
        strahl_study::page::summary(&study, Path::new("report.html"))
    };
    assert!(study(0.031).contains("warning   The reference discards 3.1 % of the light"));
    assert!(!study(0.0001).contains("warning"));
}

#[test]
fn the_page_speaks_of_nothing_that_its_reader_cannot_know() {
    let page = page("out");
    assert!(!page.contains("lecture"));
    let study = study();
    let about = study.runs.iter().filter(|run| run.measures_accuracy()).count();
    assert!(page.contains(&format!("All {about} settings of these plots")));
    assert!(page.contains(&format!("{} settings measured: {about} for accuracy", study.runs.len())));
}

/// Balls of glass between mirrors, of which every ray makes a tree of thousands.
const TREES: &str = r#"
camera = { from = [0, 0, 4.5], at = [0, 0, 0], angle = 60 }
render = { levels = 14, cutoff = 0.001, sampler = "regular:7" }
point_light = [{ position = [2, 4, 4] }]
plane = [
    { point = [0, 0, -5], normal = [0, 0, 1], material = { color = "teal", mirror = 0.9 } },
    { point = [0, 0, 5], normal = [0, 0, 1], material = { color = "ivory", mirror = 0.9 } },
]
sphere = [
    { center = [-1, 0, 0], radius = 1, material = { color = 0, transmission = 1, fresnel = true } },
    { center = [1, 0, 0], radius = 1, material = { color = 0, transmission = 1, fresnel = true } },
]
"#;

#[test]
fn no_reference_is_coarser_than_the_settings_of_the_scene_however_short_the_time() {
    let folder = Folder::with("");
    folder.write("trees.toml", TREES);
    for limit in [1, 3] {
        let begun = Instant::now();
        let said = folder.run(&format!("study trees.toml -o out{limit} --time-limit {limit}s"));
        let took = begun.elapsed();
        // To write the page takes some time, too.
        assert!(took < Duration::from_secs(limit) + Duration::from_secs(1), "{limit} s: {took:?}");
        if said.status == Some(0) {
            let study =
                Study::parse(&std::fs::read(folder.path(format!("out{limit}/study.json"))).unwrap()).unwrap();
            let setting = &study.reference.setting.settings;
            assert!(setting.levels >= 14 && setting.cutoff <= 0.001, "{setting:?}");
            // Twice as many make the reference, and no fewer than the 49 of the scene.
            let rays: u32 = setting.sampler.to_string().strip_prefix("stochastic:").unwrap().parse().unwrap();
            assert!(2 * rays >= 49, "{setting:?}");
        } else {
            said.failed(75, "is too short for a reference");
            assert!(said.stderr.contains("--time-limit"), "{}", said.stderr);
            assert!(!folder.path(format!("out{limit}")).exists());
        }
    }
}

#[test]
fn a_size_that_there_is_no_time_for_is_refused_and_what_would_be_enough_is_reported() {
    let folder = Folder::with("");
    folder.write("trees.toml", TREES);
    let begun = Instant::now();
    folder.run("study trees.toml --size 4000x3000 --time-limit 1s").failed(
        75,
        "1s is too short for a reference at least as fine as the scene's settings; use --time-limit",
    );
    assert!(begun.elapsed() < Duration::from_secs(2));
    assert_eq!(folder.names(), ["scene.nff", "trees.toml"]);
}

#[cfg(unix)]
#[test]
fn an_interrupted_study_leaves_nothing_behind() {
    let folder = Folder::with(BALL);
    let words = "study scene.nff -o a/b --full --size 400x300";
    let mut running = Running::start(folder.command(words).stdout(Stdio::null()).stderr(Stdio::null()));
    running.until(|| folder.path("a/b").exists());
    let kill = format!("kill -s INT {}", running.number());
    assert!(Command::new("sh").args(["-c", &kill]).status().unwrap().success());
    assert_eq!(running.end().code(), Some(130));
    assert_eq!(folder.names(), ["scene.nff"]);
}

/// The plot's mark with this error: from its group to the end of that.
fn mark(page: &str, error: f64) -> Option<&str> {
    let start = page.find(&format!("data-error=\"{error}\""))?;
    page[start..].split("</g>").next()
}

#[test]
fn a_point_moves_with_its_number() {
    let own = study().runs.iter().position(|run| run.role == RunRole::Own).unwrap();
    let (before, after) = (study().runs[own].error.rmse, 0.123_456);
    changed("moved", |json| json["runs"][own]["error"]["rmse"] = after.into());
    folder().done("study --from moved/study.json --quiet");
    let (old, new) = (page("out"), page("moved"));
    let place = |mark: &str| mark.split("cy=\"").nth(1).unwrap().split('"').next().unwrap().to_owned();
    let (was, is) = (mark(&old, before).unwrap(), mark(&new, after).unwrap());
    assert!(mark(&old, after).is_none());
    assert_ne!(place(was), place(is));
}

#[test]
fn a_technique_whose_absence_aborts_the_picture_has_a_lower_bound_of_its_saving() {
    changed("bound", |json| {
        let it = &mut json["techniques"][0];
        (it["without"], it["error"]) = (Value::Null, Value::Null);
        it["given_up"] = 2.5.into();
    });
    folder().done("study --from bound/study.json --quiet");
    let page = page("bound");
    assert!(page.contains("over 2.50 s → "), "no bound");
    assert!(!self::page("out").contains("over 2.50 s → "));
    // Older studies without this field can be read.
    changed("before", |json| {
        json["techniques"][0].as_object_mut().unwrap().remove("given_up");
    });
    folder().done("study --from before/study.json --quiet");
    assert_eq!(self::page("before"), self::page("out"));
}

#[test]
fn what_firmware_has_measured_is_laid_into_the_page() {
    changed("chip", |_| {});
    let rows = "scene,64,48,single,5,0.001953125,single,30720000,40000,0.0125\nscene,64,48,single,2,0.001953125,single,9216000,9000,0.25\n";
    folder().write("chip.csv", format!("{DEVICE}\n{rows}"));
    folder().done("study --from chip/study.json --device chip.csv --quiet");
    let page = page("chip");
    for text in ["On the device", "chip.csv", "10.0 k", "data-error=\"0.0125\""] {
        assert!(page.contains(text), "{text}");
    }
}

#[test]
fn what_is_no_study_is_refused_with_its_place() {
    changed("old", |json| json["version"] = 7.into());
    folder()
        .run("study --from old/study.json")
        .failed(65, "study version 7 is not supported; this program reads version 1");
    changed("other", |json| json["format"] = "recipe".into());
    folder().run("study --from other/study.json").failed(65, "its format is `recipe`");
    changed("far", |json| json["knobs"][0]["steps"][0]["run"] = 4000.into());
    folder().run("study --from far/study.json").failed(65, "run 4000 does not exist");
    changed("empty", |json| json["runs"][0]["cpu"] = Vec::<f64>::new().into());
    folder().run("study --from empty/study.json").failed(65, "run 0 has no measured time");
    folder().write("bad.json", "{ \"name\": \"package\" }");
    folder().run("study --from bad.json").failed(65, "bad.json: not a study.json file");
    folder().write("list.json", "[1, 2]");
    folder().run("study --from list.json").failed(65, "list.json: not a study.json file");
    folder().write("broken.json", "{\n  \"format\": \"strahl-study\",\n  \"version\": one\n}\n");
    folder().run("study --from broken.json").failed(65, "broken.json:3: ");
    folder().run("study --from missing.json").failed(66, "missing.json");
}

#[test]
fn what_is_no_table_of_firmware_is_refused_with_its_line() {
    folder().write("bad.csv", format!("{DEVICE}\nscene,64,48,single,5,0,single,lots,1,0\n"));
    folder()
        .run("study --from out/study.json --device bad.csv -o bad")
        .failed(65, "bad.csv:2: instructions: ");
    folder().run("study --from out/study.json --device none.csv -o bad").failed(66, "none.csv");
    assert!(!folder().path("bad").exists());
}

#[test]
fn wrong_usage_is_reported_before_any_work() {
    let folder = Folder::with(EMPTY);
    folder.run("study").failed(2, "<SCENE>");
    folder.run("study scene.nff --from study.json").failed(2, "cannot be used with");
    folder.run("study scene.nff --time-limit soon").failed(2, "--time-limit");
    folder.run("study nothing.nff").failed(66, "nothing.nff");
    folder.run("study scene.nff -o scene.nff").failed(74, "scene.nff");
}

#[test]
fn the_stored_schema_is_the_one_that_is_printed() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("study.schema.json");
    let printed = Folder::with(EMPTY).done("schema study");
    assert_eq!(String::from_utf8(printed).unwrap(), schema());
    if std::env::var_os("STRAHL_ACCEPT").is_some() {
        fs::write(&path, schema()).unwrap();
    }
    assert_eq!(fs::read_to_string(&path).unwrap(), schema(), "STRAHL_ACCEPT=1 writes it anew");
}

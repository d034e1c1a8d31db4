//! Pieces of text go through all threads, and come out in their order.
//!
//! A reader takes what there is, up to its last whole line, so that somebody who writes one ray
//! and waits is answered. Workers take pieces as they come; the rows of a piece are written when
//! those of all pieces before it have been. A fixed number of buffers goes round, so memory is
//! bounded however long the input is and whoever is slow.

use std::collections::VecDeque;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread;
use std::time::Duration;

use strahl_engine::{RayCaster, RayHit, RayQuery};
use strahl_settings::Precision;

use super::lines::{self, LONGEST, LineFault, is_header};
use super::rows;
use crate::failure::Failure;
use crate::output::Output;
use crate::signals::Signals;

/// How much is read at once, in bytes: some hundred rays, so that all threads have work to the end.
const PIECE: usize = 1 << 14;

/// Buffers for each thread.
const BUFFERS: usize = 4;

/// How long a signal may wait.
const PATIENCE: Duration = Duration::from_millis(50);

/// Rays on their way to be answered.
pub struct Stream {
    /// Where lines come from.
    pub input: Box<dyn Read + Send>,
    /// Of the input, in messages.
    pub name: PathBuf,
    /// Where rows go.
    pub output: Output,
    /// What is computed with.
    pub precision: Precision,
    /// How many threads work, at least one.
    pub threads: usize,
    /// When to stop.
    pub signals: Signals,
}

/// What was cast.
#[derive(Clone, Copy, Debug, Default)]
pub struct Cast {
    /// All rays.
    pub rays: u64,
    /// Those that hit.
    pub hits: u64,
}

/// Lines of the input.
struct Piece {
    /// Counted from 0.
    number: usize,
    /// The number of its first line, counted from 1.
    line: usize,
    text: Vec<u8>,
}

/// What comes of a piece.
#[derive(Default)]
struct Answer {
    number: usize,
    rows: Vec<u8>,
    cast: Cast,
    /// The line after the last that was answered.
    wrong: Option<(usize, LineFault)>,
    /// The memory of the piece, to be used again.
    text: Vec<u8>,
}

enum Event {
    Read(Piece),
    Answered(Answer),
    /// Nothing more comes.
    End(io::Result<()>),
}

impl Stream {
    /// Answers every ray by what `caster` makes, one for each thread.
    pub fn run<'c>(self, caster: impl Fn() -> RayCaster<'c> + Sync) -> Result<Cast, Failure> {
        let Stream { input, name, output, precision, threads, signals } = self;
        let (events, news) = mpsc::channel();
        let (buffers, free) = mpsc::channel();
        let (work, pieces) = mpsc::channel();
        for _ in 0..BUFFERS * threads {
            // The receiver is there until the reader begins.
            let _ = buffers.send(Vec::new());
        }
        // On its own and not waited for: it may hang in a read when everything else has ended.
        let told = events.clone();
        thread::spawn(move || told.send(Event::End(read(input, &free, &told))));

        let pieces = Mutex::new(pieces);
        let is_over = AtomicBool::new(false);
        thread::scope(|scope| {
            for _ in 0..threads {
                let (events, pieces, is_over, caster) = (events.clone(), &pieces, &is_over, &caster);
                scope.spawn(move || {
                    let mut cast = caster();
                    while let Some(piece) = next(pieces) {
                        let answer = answer(piece, precision, is_over, &mut cast);
                        if events.send(Event::Answered(answer)).is_err() {
                            break;
                        }
                    }
                });
            }
            let mut order =
                Order { output, waiting: VecDeque::new(), first: 0, cast: Cast::default(), buffers };
            let end = order.follow(&name, &news, &work, &signals);
            is_over.store(true, Ordering::Relaxed);
            drop(work); // the workers wait for more
            // Also when a line is wrong, what has been answered stays.
            match end {
                Ok(()) => order.output.finish().map(|()| order.cast),
                Err(failure @ Failure::Input { .. }) => order.output.finish().and(Err(failure)),
                Err(failure) => Err(failure),
            }
        })
    }
}

/// The next piece, for one of the workers.
fn next(pieces: &Mutex<Receiver<Piece>>) -> Option<Piece> {
    pieces.lock().ok()?.recv().ok()
}

/// Reads pieces into free buffers until the input ends, or nobody asks any more.
fn read(mut input: impl Read, free: &Receiver<Vec<u8>>, told: &Sender<Event>) -> io::Result<()> {
    let mut begun = Vec::new();
    let mut line = 1;
    for (number, mut text) in free.iter().enumerate() {
        text.clear();
        text.append(&mut begun);
        let is_end = fill(&mut input, &mut text, &mut begun)?;
        if !text.is_empty() {
            let lines = text.iter().filter(|byte| **byte == b'\n').count();
            if told.send(Event::Read(Piece { number, line, text })).is_err() {
                break;
            }
            line += lines;
        }
        if is_end {
            break;
        }
    }
    Ok(())
}

/// Reads whole lines behind what is in `text`; what follows them goes into `begun`. Whether there
/// is no more, or nothing that could be a line.
fn fill(input: &mut impl Read, text: &mut Vec<u8>, begun: &mut Vec<u8>) -> io::Result<bool> {
    loop {
        let start = text.len();
        text.resize(start + PIECE, 0);
        let read = match input.read(&mut text[start..]) {
            Err(error) if error.kind() == io::ErrorKind::Interrupted => Ok(None),
            read => read.map(Some),
        };
        text.truncate(start + read.as_ref().ok().copied().flatten().unwrap_or(0));
        match read? {
            None => continue,
            Some(0) => return Ok(true),
            Some(_) => {}
        }
        if let Some(last) = text[start..].iter().rposition(|byte| *byte == b'\n') {
            begun.extend_from_slice(&text[start + last + 1..]);
            text.truncate(start + last + 1);
            return Ok(false);
        }
        if text.len() > LONGEST {
            return Ok(true);
        }
    }
}

/// Casts the rays of a piece, up to the first wrong line.
fn answer(
    piece: Piece,
    precision: Precision,
    is_over: &AtomicBool,
    cast: &mut impl FnMut(&RayQuery) -> Option<RayHit>,
) -> Answer {
    let Piece { number, line, text } = piece;
    let mut answer = Answer { number, rows: Vec::with_capacity(2 * text.len()), ..Answer::default() };
    let whole = text.strip_suffix(b"\n").unwrap_or(&text);
    for (line, text) in (line..).zip(whole.split(|byte| *byte == b'\n')) {
        if is_over.load(Ordering::Relaxed) {
            break;
        }
        let text = if line == 1 { text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text) } else { text };
        let is_header = if line == 1 { is_header(text) } else { Ok(false) };
        if is_header == Ok(true) {
            answer.rows.extend_from_slice(rows::HEADER.as_bytes());
            continue;
        }
        let read = is_header.and_then(|_| lines::read(text, precision));
        match read {
            Ok(ray) => {
                let found = cast(&ray);
                answer.cast.rays += 1;
                answer.cast.hits += u64::from(found.is_some());
                rows::add(&mut answer.rows, found, precision);
            }
            Err(fault) => {
                answer.wrong = Some((line, fault));
                break;
            }
        }
    }
    answer.text = text;
    answer
}

/// Puts answers back into the order of their pieces.
struct Order {
    output: Output,
    /// Of the pieces that have been read and not written, the first first.
    waiting: VecDeque<Option<Answer>>,
    /// The number of the first.
    first: usize,
    cast: Cast,
    buffers: Sender<Vec<u8>>,
}

impl Order {
    /// Writes answers until the input has ended and all are written, or something is wrong.
    fn follow(
        &mut self,
        name: &Path,
        news: &Receiver<Event>,
        work: &Sender<Piece>,
        signals: &Signals,
    ) -> Result<(), Failure> {
        let mut end = None;
        while end.is_none() || !self.waiting.is_empty() {
            signals.check().map_err(Failure::StoppedAmid)?;
            match news.recv_timeout(PATIENCE) {
                Ok(Event::Read(piece)) => {
                    self.waiting.push_back(None);
                    // The workers are there as long as `work` is.
                    let _ = work.send(piece);
                }
                Ok(Event::Answered(answer)) => {
                    let place = answer.number - self.first;
                    if let Some(waiting) = self.waiting.get_mut(place) {
                        *waiting = Some(answer);
                    }
                    self.write(name)?;
                }
                Ok(Event::End(how)) => end = Some(how),
                Err(RecvTimeoutError::Timeout | RecvTimeoutError::Disconnected) => {}
            }
        }
        match end {
            Some(Err(error)) => Err(Failure::Unreadable { path: name.to_owned(), error }),
            _ => Ok(()),
        }
    }

    /// Writes all answers whose turn it is.
    fn write(&mut self, name: &Path) -> Result<(), Failure> {
        while let Some(Some(answer)) = self.waiting.front_mut() {
            let Answer { rows, cast, wrong, text, .. } = std::mem::take(answer);
            self.waiting.pop_front();
            self.first += 1;
            self.output.write(&rows)?;
            self.cast.rays += cast.rays;
            self.cast.hits += cast.hits;
            if let Some((line, fault)) = wrong {
                return Err(Failure::at(name, line, fault.to_string()));
            }
            // The reader may have ended.
            let _ = self.buffers.send(text);
        }
        Ok(())
    }
}

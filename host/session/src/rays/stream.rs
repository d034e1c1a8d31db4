//! A stream of rays as CSV, answered by all threads in the order of the input.
//!
//! A reader thread takes what is available, up to the last complete line, so that a program that writes one ray and waits
//! gets its answer. Workers take chunks in any order; the rows of a chunk are written once those of all chunks before it
//! have been. The number of buffers is fixed, so memory is bounded for any length of the input.

use std::collections::VecDeque;
use std::error::Error;
use std::fmt;
use std::io::{self, Read, Write};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread;
use std::time::Duration;

use strahl_engine::{Interrupt, Progress, RayCaster, RayHit, RayInput};
use strahl_settings::Precision;

use super::format;
use super::parse::{self, MAX_LINE_BYTES, RayParseError, is_header};

/// How much is read at once, in bytes: some hundred rays, so that all threads have work until the end.
const CHUNK_BYTES: usize = 1 << 14;

/// Buffers per thread.
const BUFFERS_PER_THREAD: usize = 4;

/// The longest time between two checks for cancellation.
const POLL_INTERVAL: Duration = Duration::from_millis(50);

/// Rays to be cast, as CSV.
pub struct RayStream {
    /// The input. It is read by a thread of its own, which may outlive [`RayStream::run`] if a read blocks.
    pub input: Box<dyn Read + Send>,
    /// The precision that numbers are rounded to and rays are traced with.
    pub precision: Precision,
    /// Threads that cast rays, at least one.
    pub threads: usize,
}

/// Number of rays and hits.
#[derive(Clone, Copy, Debug, Default)]
pub struct CastCounts {
    /// All rays.
    pub rays: u64,
    /// Rays that hit an object.
    pub hits: u64,
}

/// Why a stream ended early.
#[derive(Debug)]
pub enum CastError {
    /// A line is not a ray. The rows of all lines before it have been written.
    Line {
        /// The line number, from 1.
        line: usize,
        /// The error.
        error: RayParseError,
    },
    /// The input cannot be read.
    Read(io::Error),
    /// The output cannot be written.
    Write(io::Error),
    /// The work was stopped.
    Interrupted(Interrupt),
}

impl fmt::Display for CastError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CastError::Line { line, error } => write!(f, "line {line}: {error}"),
            CastError::Read(error) => write!(f, "cannot read rays: {error}"),
            CastError::Write(error) => write!(f, "cannot write hits: {error}"),
            CastError::Interrupted(interrupt) => interrupt.fmt(f),
        }
    }
}

impl Error for CastError {}

/// Complete lines of the input.
struct InputChunk {
    /// The index of the chunk.
    number: usize,
    /// The line number of its first line, from 1.
    line: usize,
    text: Vec<u8>,
}

/// The rows of a chunk.
#[derive(Default)]
struct OutputChunk {
    number: usize,
    rows: Vec<u8>,
    counts: CastCounts,
    /// The first invalid line; the rows end before it.
    error: Option<(usize, RayParseError)>,
    /// The buffer of the input chunk, for reuse.
    text: Vec<u8>,
}

enum StreamEvent {
    Read(InputChunk),
    Done(OutputChunk),
    /// The input has ended.
    End(io::Result<()>),
}

impl RayStream {
    /// Casts all rays and writes one row for each. `caster` makes the ray caster of each thread.
    pub fn run<'c>(
        self,
        output: &mut dyn Write,
        progress: &dyn Progress,
        caster: impl Fn() -> RayCaster<'c> + Sync,
    ) -> Result<CastCounts, CastError> {
        let RayStream { input, precision, threads } = self;
        let (events, news) = mpsc::channel();
        let (buffers, free) = mpsc::channel();
        let (work, chunks) = mpsc::channel();
        for _ in 0..BUFFERS_PER_THREAD * threads {
            // The receiver exists until the reader starts.
            let _ = buffers.send(Vec::new());
        }
        // A detached thread: its read may block when everything else has ended.
        let reader = events.clone();
        thread::spawn(move || reader.send(StreamEvent::End(read(input, &free, &reader))));

        let chunks = Mutex::new(chunks);
        let is_over = AtomicBool::new(false);
        thread::scope(|scope| {
            for _ in 0..threads {
                let (events, chunks, is_over, caster) = (events.clone(), &chunks, &is_over, &caster);
                scope.spawn(move || {
                    let mut cast = caster();
                    while let Some(chunk) = next(chunks) {
                        let done = process_chunk(chunk, precision, is_over, &mut cast);
                        if events.send(StreamEvent::Done(done)).is_err() {
                            break;
                        }
                    }
                });
            }
            let mut writer = OrderedWriter {
                output,
                pending: VecDeque::new(),
                next_chunk: 0,
                counts: CastCounts::default(),
                buffers,
            };
            let end = writer.run(&news, &work, progress);
            is_over.store(true, Ordering::Relaxed);
            drop(work); // The workers wait for more.
            end.map(|()| writer.counts)
        })
    }
}

/// The next chunk, for one of the workers.
fn next(chunks: &Mutex<Receiver<InputChunk>>) -> Option<InputChunk> {
    chunks.lock().ok()?.recv().ok()
}

/// Reads chunks into free buffers until the input ends or the receiver is dropped.
fn read(mut input: impl Read, free: &Receiver<Vec<u8>>, events: &Sender<StreamEvent>) -> io::Result<()> {
    let mut rest = Vec::new();
    let mut line = 1;
    for (number, mut text) in free.iter().enumerate() {
        text.clear();
        text.append(&mut rest);
        let is_end = read_whole_lines(&mut input, &mut text, &mut rest)?;
        if !text.is_empty() {
            let lines = text.iter().filter(|byte| **byte == b'\n').count();
            if events.send(StreamEvent::Read(InputChunk { number, line, text })).is_err() {
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

/// Appends complete lines to `text`; what follows the last of them goes into `rest`. Returns whether the input has ended,
/// or the line is too long to be a ray.
fn read_whole_lines(input: &mut impl Read, text: &mut Vec<u8>, rest: &mut Vec<u8>) -> io::Result<bool> {
    loop {
        let start = text.len();
        text.resize(start + CHUNK_BYTES, 0);
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
            rest.extend_from_slice(&text[start + last + 1..]);
            text.truncate(start + last + 1);
            return Ok(false);
        }
        if text.len() > MAX_LINE_BYTES {
            return Ok(true);
        }
    }
}

/// Casts the rays of a chunk, up to the first invalid line.
fn process_chunk(
    chunk: InputChunk,
    precision: Precision,
    is_over: &AtomicBool,
    cast: &mut impl FnMut(&RayInput) -> Option<RayHit>,
) -> OutputChunk {
    let InputChunk { number, line, text } = chunk;
    let mut done = OutputChunk { number, rows: Vec::with_capacity(2 * text.len()), ..OutputChunk::default() };
    let lines = text.strip_suffix(b"\n").unwrap_or(&text);
    for (line, text) in (line..).zip(lines.split(|byte| *byte == b'\n')) {
        if is_over.load(Ordering::Relaxed) {
            break;
        }
        let text = if line == 1 { text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text) } else { text };
        let is_header = if line == 1 { is_header(text) } else { Ok(false) };
        if is_header == Ok(true) {
            done.rows.extend_from_slice(format::HEADER.as_bytes());
            continue;
        }
        match is_header.and_then(|_| parse::ray(text, precision)) {
            Ok(ray) => {
                let hit = cast(&ray);
                done.counts.rays += 1;
                done.counts.hits += u64::from(hit.is_some());
                format::push_row(&mut done.rows, hit, precision);
            }
            Err(error) => {
                done.error = Some((line, error));
                break;
            }
        }
    }
    done.text = text;
    done
}

/// Writes rows in the order of the input.
struct OrderedWriter<'w> {
    output: &'w mut dyn Write,
    /// The chunks from `next_chunk` on that have been read; `None` until their rows exist.
    pending: VecDeque<Option<OutputChunk>>,
    /// The index of the chunk that is written next.
    next_chunk: usize,
    counts: CastCounts,
    buffers: Sender<Vec<u8>>,
}

impl OrderedWriter<'_> {
    /// Writes rows until the input has ended and all are written, or until an error.
    fn run(
        &mut self,
        news: &Receiver<StreamEvent>,
        work: &Sender<InputChunk>,
        progress: &dyn Progress,
    ) -> Result<(), CastError> {
        let mut end = None;
        while end.is_none() || !self.pending.is_empty() {
            progress.check().map_err(CastError::Interrupted)?;
            match news.recv_timeout(POLL_INTERVAL) {
                Ok(StreamEvent::Read(chunk)) => {
                    self.pending.push_back(None);
                    // The workers exist as long as `work` does.
                    let _ = work.send(chunk);
                }
                Ok(StreamEvent::Done(chunk)) => {
                    let index = chunk.number - self.next_chunk;
                    if let Some(pending) = self.pending.get_mut(index) {
                        *pending = Some(chunk);
                    }
                    self.write()?;
                }
                Ok(StreamEvent::End(result)) => end = Some(result),
                Err(RecvTimeoutError::Timeout | RecvTimeoutError::Disconnected) => {}
            }
        }
        match end {
            Some(Err(error)) => Err(CastError::Read(error)),
            _ => Ok(()),
        }
    }

    /// Writes all chunks that are next in order.
    fn write(&mut self) -> Result<(), CastError> {
        while let Some(Some(chunk)) = self.pending.front_mut() {
            let OutputChunk { rows, counts, error, text, .. } = std::mem::take(chunk);
            self.pending.pop_front();
            self.next_chunk += 1;
            self.output.write_all(&rows).map_err(CastError::Write)?;
            self.counts.rays += counts.rays;
            self.counts.hits += counts.hits;
            if let Some((line, error)) = error {
                return Err(CastError::Line { line, error });
            }
            // The reader may have ended.
            let _ = self.buffers.send(text);
        }
        Ok(())
    }
}

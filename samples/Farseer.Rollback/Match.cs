using System;
using System.Diagnostics;
using System.Threading;

namespace Farseer.Rollback;

/// <summary>A match of two sides in one process, which know of each other only what comes over UDP.</summary>
internal sealed class Match : IDisposable
{
    private static readonly TimeSpan _patience = TimeSpan.FromSeconds(30);

    private readonly MatchOptions _options;
    private readonly BallGame[] _games = new BallGame[BallGame.Players];
    private readonly RollbackPeer[] _peers = new RollbackPeer[BallGame.Players];
    private readonly UdpLink[] _links = new UdpLink[BallGame.Players];
    private readonly PoorLine[] _lines = new PoorLine[BallGame.Players];

    public Match(MatchOptions options)
    {
        _options = options;
        _links[0] = UdpLink.Host();
        _links[1] = _links[0].Join();
        for (int i = 0; i < BallGame.Players; i++)
        {
            BallGame game = _games[i] = new BallGame(options.MostAhead + 2);
            Bot bot = new(i, options.Seed);
            RollbackPeer peer = _peers[i] = new RollbackPeer(game, i, () => bot.Choose(game), options.InputDelay, options.MostAhead,
                options.Frames);
            _links[i].Received += bytes => peer.Receive(bytes);
            _lines[i] = new PoorLine(options.Quality, options.Seed + (1000 * (i + 1)), _links[i].Send);
        }
    }

    public RollbackPeer Peer(int number) => _peers[number];

    public BallGame Game(int number) => _games[number];

    public PoorLine Line(int number) => _lines[number];

    /// <summary>Plays to the end.</summary>
    /// <exception cref="TimeoutException">Nothing got through for too long.</exception>
    public void Play()
    {
        Connect();
        TimeSpan tick = TimeSpan.FromSeconds(BallGame.Dt / _options.Pace);
        Stopwatch clock = Stopwatch.StartNew();
        TimeSpan limit = _patience + (20 * _options.Frames * tick);
        for (int ticks = 0; !(_peers[0].IsFinished && _peers[1].IsFinished); ticks++)
        {
            if (clock.Elapsed > limit)
            {
                throw new TimeoutException($"The match stood still at frames {_peers[0].Frame} and {_peers[1].Frame}.");
            }

            double now = ticks * BallGame.Dt * 1000.0;
            for (int i = 0; i < BallGame.Players; i++)
            {
                _links[i].Poll();
                _peers[i].Tick();
                _lines[i].Send(_peers[i].Packet(), now);
                _lines[i].Deliver(now);
            }

            TimeSpan ahead = ((ticks + 1) * tick) - clock.Elapsed;
            if (ahead > TimeSpan.Zero)
            {
                Thread.Sleep(ahead);
            }
        }
    }

    /// <summary>The checksum of a third game that is told all inputs at once and never goes back.</summary>
    public ulong Straight()
    {
        BallGame game = new(1);
        for (int frame = 0; frame < _options.Frames; frame++)
        {
            game.Advance([_peers[0].InputOf(0, frame), _peers[0].InputOf(1, frame)]);
        }

        return game.Checksum;
    }

    public void Dispose()
    {
        foreach (UdpLink link in _links)
        {
            link.Dispose();
        }
    }

    private void Connect()
    {
        Stopwatch clock = Stopwatch.StartNew();
        while (!(_links[0].IsConnected && _links[1].IsConnected))
        {
            if (clock.Elapsed > _patience)
            {
                throw new TimeoutException("The two sides could not connect over UDP.");
            }

            _links[0].Poll();
            _links[1].Poll();
            Thread.Sleep(1);
        }
    }
}

/// <summary>How a match is played.</summary>
/// <param name="Frames">Updates of the game.</param>
/// <param name="Quality">The line in each direction.</param>
/// <param name="InputDelay">Frames after which an own input acts.</param>
/// <param name="MostAhead">Frames that may be done without the other's input.</param>
/// <param name="Pace">Times as fast as the clock.</param>
/// <param name="Seed">Of the players' whims and of what the line loses.</param>
internal sealed record MatchOptions(int Frames, LineQuality Quality, int InputDelay, int MostAhead, double Pace, int Seed);

using System;
using System.Collections.Generic;
using System.Diagnostics;

namespace Farseer.Rollback;

/// <summary>
/// One side of a game for two. It never waits for the other's input: it predicts that the other goes on as before, and where that was wrong
/// goes back and does the frames again.
/// </summary>
internal sealed class RollbackPeer
{
    private const int CheckEvery = 60;

    private readonly IRollbackGame _game;
    private readonly Func<PlayerInput> _choose;
    private readonly int _number;
    private readonly int _delay;
    private readonly int _mostAhead;
    private readonly int _end;

    // By frame: what is known, and what the frames were done with.
    private readonly List<PlayerInput> _own = [];
    private readonly List<PlayerInput> _other = [];
    private readonly List<PlayerInput> _predicted = [];
    private readonly Dictionary<int, ulong> _checksums = [];
    private readonly PlayerInput[] _inputs = new PlayerInput[2];
    private int _otherHas;
    private int _wrongFrom = int.MaxValue;

    /// <param name="game">The game of this side.</param>
    /// <param name="number">This player: 0 or 1.</param>
    /// <param name="choose">What the player of this side holds down now.</param>
    /// <param name="delay">Frames after which an own input acts; less to do again for a bit of lag.</param>
    /// <param name="mostAhead">Frames that may be done without the other's input.</param>
    /// <param name="end">Frames of the game.</param>
    public RollbackPeer(IRollbackGame game, int number, Func<PlayerInput> choose, int delay, int mostAhead, int end)
    {
        _game = game;
        _number = number;
        _choose = choose;
        _delay = delay;
        _mostAhead = mostAhead;
        _end = end;
        for (int i = 0; i < delay; i++)
        {
            _own.Add(PlayerInput.None);
        }
    }

    public int Frame { get; private set; }

    public PeerFigures Figures { get; } = new();

    /// <summary>All frames are done, and none with a prediction; and the other has what it needs.</summary>
    public bool IsFinished => Frame == _end && _other.Count >= _end && _wrongFrom >= _end && _otherHas >= _end;

    public PlayerInput InputOf(int player, int frame) => (player == _number ? _own : _other)[frame];

    /// <summary>What came from the other side. Packets may come twice, in any order, or never.</summary>
    public void Receive(ReadOnlySpan<byte> bytes)
    {
        if (InputPacket.Read(bytes) is not { } packet || packet.First < 0 || packet.First > _other.Count)
        {
            return;
        }

        _otherHas = Math.Max(_otherHas, Math.Min(packet.Next, _own.Count));
        for (int i = _other.Count - packet.First; i < packet.Inputs.Length; i++)
        {
            int frame = _other.Count;
            _other.Add((PlayerInput)packet.Inputs[i]);
            if (frame < Frame && _predicted[frame] != _other[frame])
            {
                _wrongFrom = Math.Min(_wrongFrom, frame);
            }
        }

        if (packet.CheckedFrame > 0 && packet.CheckedFrame <= Known && _checksums.TryGetValue(packet.CheckedFrame, out ulong own)
            && _wrongFrom > packet.CheckedFrame)
        {
            Figures.Checked++;
            Figures.Unequal += own == packet.Checksum ? 0 : 1;
        }
    }

    /// <summary>
    /// A frame of the clock: corrects what was predicted wrongly, then goes on by one frame if the other is not too far behind.
    /// </summary>
    public void Tick()
    {
        Correct();
        if (Frame == _end)
        {
            return;
        }

        if (Frame - _other.Count >= _mostAhead)
        {
            Figures.Waits++;
            return;
        }

        _own.Add(_choose());
        Advance();
    }

    /// <summary>What the other side may not have yet.</summary>
    public byte[] Packet()
    {
        int count = _own.Count - _otherHas;
        byte[] inputs = new byte[count];
        for (int i = 0; i < count; i++)
        {
            inputs[i] = (byte)_own[_otherHas + i];
        }

        int check = Math.Min(Known, _wrongFrom) / CheckEvery * CheckEvery;
        bool hasCheck = _checksums.TryGetValue(check, out ulong checksum);
        return new InputPacket(_other.Count, _otherHas, hasCheck ? check : 0, checksum, inputs).ToBytes();
    }

    /// <summary>The last frame that no prediction has a part in.</summary>
    private int Known => Math.Min(Frame, _other.Count);

    private void Correct()
    {
        if (_wrongFrom >= Frame)
        {
            _wrongFrom = int.MaxValue;
            return;
        }

        long start = Stopwatch.GetTimestamp();
        int depth = Frame - _wrongFrom;
        _game.Load(_wrongFrom);
        Frame = _wrongFrom;
        _predicted.RemoveRange(Frame, _predicted.Count - Frame);
        _wrongFrom = int.MaxValue;
        for (int i = 0; i < depth; i++)
        {
            // The frame that it went back to is held still.
            Advance(isHeld: i == 0);
        }

        Figures.AddRollback(depth, Stopwatch.GetElapsedTime(start));
    }

    private void Advance(bool isHeld = false)
    {
        if (!isHeld)
        {
            long start = Stopwatch.GetTimestamp();
            _game.Save(Frame);
            Figures.SaveTime += Stopwatch.GetElapsedTime(start);
            Figures.Saves++;
        }

        if (Frame % CheckEvery == 0)
        {
            _checksums[Frame] = _game.Checksum;
        }

        PlayerInput other = Frame < _other.Count ? _other[Frame] : _other.Count > 0 ? _other[^1] : PlayerInput.None;
        _predicted.Add(other);
        _inputs[_number] = _own[Frame];
        _inputs[1 - _number] = other;
        _game.Advance(_inputs);
        Frame++;
    }
}

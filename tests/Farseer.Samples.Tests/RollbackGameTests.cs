using System;
using Farseer.Rollback;
using Xunit;

namespace Farseer.Samples.Tests;

/// <summary>The rollback game over UDP on this machine.</summary>
public sealed class RollbackGameTests
{
    private const int Frames = 600;

    [Theory]
    [InlineData(40, 60, 15, 2, 7)]
    [InlineData(120, 90, 30, 0, 8)]
    public void Match_OverAPoorLine_EndsWithTheSameBitsOnBothSides(double latency, double jitter, double loss, int delay, int seed)
    {
        using Match match = new(new MatchOptions(Frames, new LineQuality(latency, jitter, loss), delay, MostAhead: 24, Pace: 10, seed));

        match.Play();

        ulong straight = match.Straight();
        for (int i = 0; i < BallGame.Players; i++)
        {
            PeerFigures figures = match.Peer(i).Figures;
            Assert.Equal(straight, match.Game(i).Checksum);
            Assert.True(figures.Rollbacks > 5 && figures.Deepest > 3, $"{figures.Rollbacks} rollbacks, {figures.Deepest} deep");
            Assert.True(match.Line(i).Lost > 10, $"{match.Line(i).Lost} packets were lost");
            Assert.True(figures.Checked > 0, "no checksum came over the line");
            Assert.Equal(0, figures.Unequal);
        }
    }

    [Fact]
    public void Match_WithoutDelay_NeverGuessesFarAhead()
    {
        using Match match = new(new MatchOptions(200, new LineQuality(0, 0, 0), InputDelay: 2, MostAhead: 8, Pace: 2, Seed: 3));

        match.Play();

        Assert.Equal(match.Game(0).Checksum, match.Game(1).Checksum);
        Assert.InRange(match.Peer(0).Figures.Deepest, 0, 8);
    }

    [Theory]
    [InlineData("")]
    [InlineData("00")]
    [InlineData("ffffffffffffffffffffffffffffffffffffffffffffffff")]
    [InlineData("ffffff7f00000000000000000000000000000000ff")]
    [InlineData("000000000000008000000000000000000000000001")]
    public void Receive_OfBytesThatAreNoPacket_ChangesNothing(string hex)
    {
        BallGame game = new(10);
        ulong before = game.Checksum;
        RollbackPeer peer = new(game, 0, () => PlayerInput.None, delay: 2, mostAhead: 8, end: 100);

        peer.Receive(Convert.FromHexString(hex));
        InputPacket sent = InputPacket.Read(peer.Packet())!;

        Assert.Equal(before, game.Checksum);
        Assert.InRange(sent.First, 0, 2);
    }
}

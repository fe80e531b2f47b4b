using System;
using System.IO;
using System.Threading.Tasks;
using Microsoft.Extensions.DependencyInjection;
using Orleans;
using Orleans.Runtime;
using Orleans.Serialization;
using Orleans.Storage;
using Xunit;

namespace Farseer.Rooms.Tests;

public sealed class FolderStorageTests : IDisposable
{
    private const string Name = "world";
    private readonly string _folder = Directory.CreateTempSubdirectory("farseer-rooms").FullName;
    private readonly GrainId _room = GrainId.Create("room", "1");
    private readonly FolderStorage _storage;

    public FolderStorageTests() =>
        _storage = new FolderStorage(
            _folder, new ServiceCollection().AddSerializer().BuildServiceProvider().GetRequiredService<Serializer>());

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public async Task Read_OfWhatWasWritten_GivesIt()
    {
        await _storage.WriteStateAsync(Name, _room, State(7));

        GrainState<RoomState> read = new();
        await _storage.ReadStateAsync(Name, _room, read);

        Assert.True(read.RecordExists);
        Assert.Equal((7L, true), (read.State!.Steps, read.State.IsRunning));
        Assert.Equal([1, 2, 7], read.State!.File);
    }

    [Fact]
    public async Task Read_OfWhatIsNotThere_GivesANewState()
    {
        GrainState<RoomState> read = State(7);

        await _storage.ReadStateAsync(Name, _room, read);

        Assert.False(read.RecordExists);
        Assert.Null(read.ETag);
        Assert.Empty(read.State!.File);
    }

    [Fact]
    public async Task Write_OverWhatSomebodyElseWrote_IsRefused()
    {
        GrainState<RoomState> mine = State(1);
        GrainState<RoomState> theirs = new();
        await _storage.WriteStateAsync(Name, _room, mine);
        await _storage.ReadStateAsync(Name, _room, theirs);
        theirs.State!.Steps = 2;
        await _storage.WriteStateAsync(Name, _room, theirs);

        await Assert.ThrowsAsync<InconsistentStateException>(() => _storage.WriteStateAsync(Name, _room, mine));
        await Assert.ThrowsAsync<InconsistentStateException>(() => _storage.ClearStateAsync(Name, _room, mine));

        GrainState<RoomState> read = new();
        await _storage.ReadStateAsync(Name, _room, read);
        Assert.Equal(2, read.State!.Steps);
        Assert.Single(Directory.GetFiles(_folder));
    }

    [Fact]
    public async Task Clear_TakesTheFileAway()
    {
        GrainState<RoomState> mine = State(1);
        await _storage.WriteStateAsync(Name, _room, mine);

        await _storage.ClearStateAsync(Name, _room, mine);

        Assert.Empty(Directory.GetFiles(_folder));
        Assert.False(mine.RecordExists);
        Assert.Empty(mine.State!.File);
    }

    private static GrainState<RoomState> State(int steps) => new()
    {
        State = new RoomState { File = [1, 2, (byte)steps], Steps = steps, IsRunning = true },
    };
}
